// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/overturning.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace Voussoir
{
namespace
{
/** Moments in units of a small part of the largest, so that sums are exact. */
using Units = std::int64_t;
constexpr double units_of_largest = 1e12;
/** The part of all torques that is rounding where it cannot be taken up. */
constexpr double rounding_of_flow = 1e-9;

using Traits = boost::
    adjacency_list_traits<boost::vecS, boost::vecS, boost::bidirectionalS>;
using Vertex = Traits::vertex_descriptor;
using Edge = Traits::edge_descriptor;

/** The properties that the algorithm works with. */
struct OfVertex
{
  boost::default_color_type colour;
  Edge predecessor;
  long distance;
};
struct OfEdge
{
  Units capacity, residual;
  Edge reverse;
};
using Graph = boost::adjacency_list<boost::vecS,
                                    boost::vecS,
                                    boost::bidirectionalS,
                                    OfVertex,
                                    OfEdge>;

void connect(Graph &graph,
             const Vertex from,
             const Vertex to,
             const Units capacity,
             const Units capacity_back)
{
  const Edge edge = add_edge(from, to, graph).first;
  const Edge back = add_edge(to, from, graph).first;
  graph[edge] = {capacity, 0, back};
  graph[back] = {capacity_back, 0, edge};
}

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
  const Packing &packing = scene.packing;
  const unsigned int n = packing.n_cells() + 1;
  const Vertex source = n, sink = n + 1;
  double largest = 0.;
  for (const double torque : torques)
    largest = std::max(largest, std::abs(torque));
  const double unit = largest / units_of_largest;
  Graph graph(n + 2);
  Units total = 0, supplied = 0;
  const auto supply = [&](const unsigned int c, const Units torque) {
    if (torque > 0)
      connect(graph, source, c, torque, 0);
    else if (torque < 0)
      connect(graph, c, sink, -torque, 0);
    total += torque;
    supplied += std::max<Units>(torque, 0);
  };
  for (unsigned int c = 0; c < torques.size(); ++c)
    supply(c, std::llround(torques[c] / unit));
  supply(packing.ground(), -total);
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
  {
    const Packing::Interface &i = packing.interfaces()[e];
    // No interface passes on more than all there is.
    const Units couple = std::llround(
        std::min(largest_couple(scene, forces, e) / unit, 1. * supplied));
    connect(graph, i.cell_minus, i.cell_plus, couple, couple);
  }
  const Units taken_up = boost::boykov_kolmogorov_max_flow(
      graph, get(&OfEdge::capacity, graph), get(&OfEdge::residual, graph),
      get(&OfEdge::reverse, graph), get(&OfVertex::predecessor, graph),
      get(&OfVertex::colour, graph), get(&OfVertex::distance, graph),
      get(boost::vertex_index, graph), source, sink);
  if (supplied - taken_up <= rounding_of_flow * supplied)
    return {};
  std::vector<bool> cut(n);
  for (unsigned int c = 0; c < n; ++c)
    cut[c] = graph[c].colour == graph[source].colour;
  // The other side is cut off as well; the ground does not turn.
  if (cut[packing.ground()])
    cut.flip();
  return cut;
}
} // namespace

std::optional<Overturning> find_overturning(const Scene &scene,
                                            const InterfaceForces &forces)
{
  const Packing &packing = scene.packing;
  const std::vector<double> torques = residual_torques(scene, forces);
  const std::vector<bool> cut = cut_off(scene, forces, torques);
  if (cut.empty())
    return {};

  boost::disjoint_sets_with_storage<> sets(cut.size());
  for (const Packing::Interface &i : packing.interfaces())
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
    const Packing::Interface &i = packing.interfaces()[e];
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
