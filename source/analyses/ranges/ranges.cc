// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/range_search.h>
#include <voussoir/analyses/ranges/ranges.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <utility>

namespace Voussoir
{
namespace
{
/** Functions are normal and tangential forces, or x and y, in turn. */
constexpr unsigned int n_kinds = 2;

/**
 * The numbers of the interfaces that are wanted, in the order of a curve of
 * Hilbert through their midpoints: of neighbours the programmes end in vertices
 * that are close to each other.
 */
std::vector<unsigned int> along_curve(const Packing<2> &packing,
                                      const std::vector<bool> &wanted)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<std::pair<Kernel::Point_2, unsigned int>> places;
  for (unsigned int e = 0; e < wanted.size(); ++e)
    if (wanted[e])
    {
      const dealii::Point<2> x = packing.interfaces()[e].midpoint();
      places.push_back({{x[0], x[1]}, e});
    }
  using Map = CGAL::First_of_pair_property_map<decltype(places)::value_type>;
  CGAL::hilbert_sort(places.begin(), places.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>());
  std::vector<unsigned int> numbers;
  for (const auto &place : places)
    numbers.push_back(place.second);
  return numbers;
}
} // namespace

Ranges
find_ranges(const Scene &scene, const RangesWanted &wanted, Terminal &terminal)
{
  const std::vector<unsigned int> interfaces =
      along_curve(scene.packing, wanted.interfaces);
  std::vector<ForceFunction> functions;
  for (const unsigned int e : interfaces)
  {
    functions.push_back(normal_force(e));
    functions.push_back(tangential_force(e));
  }
  std::vector<StraightRun> supports;
  if (wanted.reactions)
    supports = straight_supports(scene.packing);
  for (const StraightRun &support : supports)
    for (unsigned int i = 0; i < 2; ++i)
    {
      dealii::Tensor<1, 2> direction;
      direction[i] = 1.;
      functions.push_back(reaction(scene.packing, support, direction));
    }

  if (wanted.links)
    for (unsigned int k = 0; k < scene.links.size(); ++k)
      functions.push_back(force_of_link(k));

  const bool has_places =
      scene.turns() && scene.tensile_strength.empty() && !interfaces.empty();
  const std::vector<unsigned int> no_interfaces;
  RangeSearch<Scene> search(scene, functions, n_kinds,
                            has_places ? interfaces : no_interfaces,
                            wanted.method, wanted.journal, terminal);
  search.find_all();
  const std::size_t n = wanted.interfaces.size();
  Ranges ranges;
  ranges.proofs = search.proofs;
  ranges.reference = search.reference();
  ranges.wanted = wanted.interfaces;
  ranges.normal.resize(n);
  ranges.tangential.resize(n);
  if (has_places)
    ranges.eccentricity.resize(n);
  auto next = search.ranges().begin();
  for (std::size_t k = 0; k < interfaces.size(); ++k)
  {
    const unsigned int e = interfaces[k];
    ranges.normal[e] = *next++;
    ranges.tangential[e] = *next++;
    if (has_places)
      ranges.eccentricity[e] = search.places()[k];
  }
  for (unsigned int s = 0; s < supports.size(); ++s, next += 2)
    ranges.reactions.push_back({{next[0], next[1]}});
  ranges.links.assign(next, search.ranges().end());
  ranges.supports = std::move(supports);
  return ranges;
}
} // namespace Voussoir
