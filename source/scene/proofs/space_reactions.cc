// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/lowest_in_sets.h>
#include <voussoir/scene/proofs/space_reactions.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
/** The angle between two planes, and their distance over the size of the
 * larger face, that are none. */
constexpr double same_plane = 1e-6;

bool are_in_one_plane(const Packing<3>::Interface &a,
                      const Packing<3>::Interface &b)
{
  return (a.normal - b.normal).norm() <= same_plane &&
         std::abs((a.centroid - b.centroid) * a.normal) <=
             same_plane * std::max(std::sqrt(std::max(a.area, b.area)),
                                   a.centroid.distance(b.centroid));
}

/** Of each support the lowest one of those that it is one with. */
std::vector<unsigned int> lowest_supports(const Packing<3> &packing)
{
  const auto &interfaces = packing.interfaces();
  const unsigned int n = packing.n_supports(), first = interfaces.size() - n;
  std::vector<std::vector<unsigned int>> below(packing.n_cells());
  for (unsigned int k = 0; k < n; ++k)
    below[interfaces[first + k].cell_minus].push_back(k);
  boost::disjoint_sets_with_storage<> sets(n);
  const auto unite = [&](const unsigned int c, const unsigned int d) {
    for (const unsigned int k : below[c])
      for (const unsigned int l : below[d])
        if (are_in_one_plane(interfaces[first + k], interfaces[first + l]))
          sets.union_set(k, l);
  };
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    unite(c, c);
  for (unsigned int e = 0; e < first; ++e)
    unite(interfaces[e].cell_minus, interfaces[e].cell_plus);
  return lowest_in_sets(sets, n);
}
} // namespace

std::vector<PlaneSupport> plane_supports(const Packing<3> &packing)
{
  const auto &interfaces = packing.interfaces();
  const unsigned int first = interfaces.size() - packing.n_supports();
  const std::vector<unsigned int> lowest = lowest_supports(packing);
  std::map<unsigned int, PlaneSupport> by_lowest;
  for (unsigned int k = 0; k < lowest.size(); ++k)
  {
    const Packing<3>::Interface &i = interfaces[first + k];
    PlaneSupport &support = by_lowest[lowest[k]];
    support.interfaces.push_back(first + k);
    support.normal = interfaces[first + lowest[k]].normal;
    support.centroid += i.area * i.centroid;
    support.area += i.area;
  }
  std::vector<PlaneSupport> supports;
  for (auto &[number, support] : by_lowest)
  {
    support.centroid /= support.area;
    supports.push_back(std::move(support));
  }
  std::stable_sort(supports.begin(), supports.end(),
                   [](const PlaneSupport &a, const PlaneSupport &b) {
                     const auto &x = a.centroid, &y = b.centroid;
                     return std::tie(x[0], x[1], x[2]) <
                            std::tie(y[0], y[1], y[2]);
                   });
  return supports;
}

std::vector<SpaceReaction> reactions(const Packing<3> &packing,
                                     const FaceForces &forces)
{
  std::vector<SpaceReaction> found;
  for (PlaneSupport &support : plane_supports(packing))
  {
    SpaceReaction of = {std::move(support), {}, {}, {}};
    for (const unsigned int e : of.support.interfaces)
      for (unsigned int k = forces.first[e]; k < forces.first[e + 1]; ++k)
      {
        of.force += forces.list[k].force;
        of.moment += cross_product_3d(
            forces.list[k].place - of.support.centroid, forces.list[k].force);
      }
    of.place = of.support.centroid;
    const Tensor<1, 3> &normal = of.support.normal;
    // n x (r x N n) = N (r - (r . n) n).
    if (const double pressure = of.force * normal; pressure < 0.)
      of.place += cross_product_3d(normal, of.moment) / pressure;
    found.push_back(std::move(of));
  }
  return found;
}

FaceFunction reaction(const PlaneSupport &support, const unsigned int i)
{
  Tensor<1, 3> direction;
  direction[i] = 1.;
  FaceFunction sum;
  for (const unsigned int e : support.interfaces)
    sum.terms.push_back({e, direction});
  return sum;
}
} // namespace Voussoir
