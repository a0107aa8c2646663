// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/range_search.h>
#include <voussoir/analyses/ranges/space_ranges.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** A component of a unit vector that is rounding. */
constexpr double no_component = 1e-12;

/** The functions of a search, and where their ranges go. */
struct RangeList
{
  std::vector<FaceFunction> functions;
  std::vector<Range *> ranges;

  void add(FaceFunction function, Range &range)
  {
    functions.push_back(std::move(function));
    ranges.push_back(&range);
  }
};

/** True if the forces across @p normal have a component in that direction. */
bool has_shear(const dealii::Tensor<1, 3> &normal, const unsigned int i)
{
  return 1. - std::abs(normal[i]) > no_component;
}
} // namespace

SpaceRanges find_ranges(const SpaceScene &scene,
                        const RangesWanted &wanted,
                        Terminal &terminal)
{
  const Packing<3> &packing = scene.packing();
  const std::size_t n = wanted.interfaces.size();
  SpaceRanges found;
  found.wanted = wanted.interfaces;
  found.normal.resize(n);
  found.shear.resize(n);
  if (wanted.reactions)
    found.supports = plane_supports(packing);
  found.reactions.resize(found.supports.size());
  RangeList list;
  for (unsigned int e = 0; e < n; ++e)
    if (wanted.interfaces[e])
    {
      list.add(normal_force(packing, e), found.normal[e]);
      for (unsigned int i = 0; i < 3; ++i)
        if (has_shear(packing.interfaces()[e].normal, i))
          list.add(shear_force(packing, e, i), found.shear[e][i]);
    }
  for (unsigned int s = 0; s < found.supports.size(); ++s)
    for (unsigned int i = 0; i < 3; ++i)
      list.add(reaction(found.supports[s], i), found.reactions[s][i]);
  const std::vector<unsigned int> no_places;
  RangeSearch<SpaceScene> search(scene, list.functions, 1, no_places,
                                 wanted.method, wanted.journal, terminal);
  search.find_all();
  for (std::size_t k = 0; k < list.ranges.size(); ++k)
    *list.ranges[k] = search.ranges()[k];
  found.proofs = search.proofs;
  found.reference = search.reference();
  return found;
}

bool SpaceRanges::is_unbounded(const unsigned int e) const
{
  return wanted[e] &&
         !(normal[e].is_bounded() &&
           std::all_of(shear[e].begin(), shear[e].end(),
                       [](const Range &of) { return of.is_bounded(); }));
}

bool SpaceRanges::is_determined(const unsigned int e) const
{
  const auto is_one = [this](const Range &of) {
    return of.greatest - of.least <= Ranges::least_range * reference;
  };
  return wanted[e] && is_one(normal[e]) &&
         std::all_of(shear[e].begin(), shear[e].end(), is_one);
}
} // namespace Voussoir
