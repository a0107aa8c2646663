// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/proofs/network.h>
#include <voussoir/scene/proofs/overturning.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace Voussoir
{
namespace
{
/** Moments in units of a small part of the largest, so that sums are exact. */
using Units = Network::Units;
constexpr double units_of_largest = 1e12;
/** The part of all torques that is rounding where it cannot be taken up. */
constexpr double rounding_of_flow = 1e-9;

double largest_couple(const Scene &scene,
                      const InterfaceForces &forces,
                      const unsigned int e)
{
  return 0.5 * std::abs(forces.normal[e]) *
         scene.packing.interfaces()[e].length;
}

/**
 * The vertices are the cells, the ground, the source and the sink.
 *
 * @return of each cell and the ground, whether the flow cuts it off from the
 *   sink; empty if nothing is cut off.
 */
std::vector<bool> cut_off(const Scene &scene,
                          const InterfaceForces &forces,
                          const std::vector<double> &torques)
{
  const Packing<2> &packing = scene.packing;
  const unsigned int n = packing.n_cells() + 1;
  const unsigned int source = n, sink = n + 1;
  double largest = 0.;
  for (const double torque : torques)
    largest = std::max(largest, std::abs(torque));
  const double unit = largest / units_of_largest;
  Network network(n + forces.normal.size());
  Units total = 0, supplied = 0;
  const auto supply = [&](const unsigned int c, const Units torque) {
    if (torque > 0)
      network.connect(source, c, torque, 0);
    else if (torque < 0)
      network.connect(c, sink, -torque, 0);
    total += torque;
    supplied += std::max<Units>(torque, 0);
  };
  for (unsigned int c = 0; c < torques.size(); ++c)
    supply(c, std::llround(torques[c] / unit));
  supply(packing.ground(), -total);
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
  {
    const Packing<2>::Interface &i = packing.interfaces()[e];
    // No interface passes on more than all there is.
    const Units couple = std::llround(
        std::min(largest_couple(scene, forces, e) / unit, 1. * supplied));
    network.connect(i.cell_minus, i.cell_plus, couple, couple);
  }
  const Units taken_up = network.largest_flow(source, sink, n + 2);
  if (supplied - taken_up <= rounding_of_flow * supplied)
    return {};
  std::vector<bool> cut(n);
  for (unsigned int c = 0; c < n; ++c)
    cut[c] = network.is_cut_off(c);
  // The other side is cut off as well; the ground does not turn.
  if (cut[packing.ground()])
    cut.flip();
  return cut;
}
} // namespace

std::optional<Overturning> find_overturning(const Scene &scene,
                                            const InterfaceForces &forces)
{
  const Packing<2> &packing = scene.packing;
  const std::vector<double> torques = residual_torques(scene, forces);
  const std::vector<bool> cut = cut_off(scene, forces, torques);
  if (cut.empty())
    return {};

  boost::disjoint_sets_with_storage<> sets(cut.size());
  for (const Packing<2>::Interface &i : packing.interfaces())
    if (cut[i.cell_minus] && cut[i.cell_plus])
      sets.union_set(i.cell_minus, i.cell_plus);
  std::map<unsigned int, Overturning> groups;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (cut[c])
    {
      Overturning &group = groups[sets.find_set(c)];
      group.cells.push_back(c);
      group.moment += torques[c];
    }
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
  {
    const Packing<2>::Interface &i = packing.interfaces()[e];
    if (cut[i.cell_minus] == cut[i.cell_plus])
      continue;
    Overturning &group =
        groups[sets.find_set(cut[i.cell_minus] ? i.cell_minus : i.cell_plus)];
    group.interfaces.push_back(e);
    group.resistance += largest_couple(scene, forces, e);
  }
  const auto left = [](const auto &group) {
    return std::abs(group.second.moment) - group.second.resistance;
  };
  return std::max_element(
             groups.begin(), groups.end(),
             [&](const auto &a, const auto &b) { return left(a) < left(b); })
      ->second;
}
} // namespace Voussoir
