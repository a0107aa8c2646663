// SPDX-License-Identifier: LGPL-2.1-or-later

// No order of cells or vertices changes a force.

#include "judgement.h"
#include "room.h"
#include <array>
#include <map>
#include <numeric>
#include <random>

namespace test_numbering
{
using namespace Voussoir;

/** The forces between two cells, by their old numbers. */
using Forces =
    std::map<std::pair<unsigned int, unsigned int>, std::array<double, 2>>;

/**
 * Cells in the order @p old_number, each loop begun at a vertex of its own, and
 * vertices turned by @p turn.
 */
CellLoops renumbered(const CellLoops &cells,
                     const std::vector<unsigned int> &old_number,
                     const unsigned int turn)
{
  CellLoops result;
  const unsigned int n_vertices = cells.vertices.size();
  for (unsigned int v = 0; v < n_vertices; ++v)
    result.vertices.push_back(cells.vertices[(v + turn) % n_vertices]);
  const auto new_vertex = [&](const unsigned int v) {
    return (v + n_vertices - turn % n_vertices) % n_vertices;
  };
  for (const unsigned int c : old_number)
  {
    const unsigned int n = cells.first[c + 1] - cells.first[c];
    for (unsigned int i = 0; i < n; ++i)
      result.loops.push_back(
          new_vertex(cells.loops[cells.first[c] + (i + turn * (c + 1)) % n]));
    result.first.push_back(result.loops.size());
    result.centres.push_back(cells.centres[c]);
  }
  return result;
}

Forces forces_by_pair(const CellLoops &cells,
                      const std::vector<unsigned int> &old_number,
                      const unsigned int turn,
                      const Method &method)
{
  const Scene scene =
      scene_under_stress(Packing<2>(renumbered(cells, old_number, turn)), 0.35,
                         tensor(-1.2, 0.1, 0.1, -0.8));
  const Judgement found = judge(scene, method);
  Forces forces;
  for (unsigned int e = 0; e < found.forces.normal.size(); ++e)
  {
    const auto &i = scene.packing.interfaces()[e];
    const unsigned int a = old_number[i.cell_minus];
    const unsigned int b = old_number[i.cell_plus];
    // Both components are the same seen from the other side.
    forces[{std::min(a, b), std::max(a, b)}] = {
        {found.forces.normal[e], found.forces.tangential[e]}};
  }
  if (found.verdict != Verdict::carried)
    forces.clear();
  return forces;
}

double difference(const Forces &a, const Forces &b)
{
  if (a.size() != b.size() || a.empty())
    return 1e300;
  Worst worst;
  for (const auto &[pair, force] : a)
    for (unsigned int k = 0; k < 2; ++k)
      worst.add(b.count(pair) == 0 ? 1e300
                                   : std::abs(force[k] - b.at(pair)[k]));
  return worst.error;
}

void try_orders(const unsigned int n_cells, const unsigned int n_orders)
{
  const CellLoops cells =
      voronoi_cells(random_points(n_cells, 4), Rectangle{{0., 0.}, {1., 1.}});
  std::vector<unsigned int> identity(n_cells);
  std::iota(identity.begin(), identity.end(), 0);
  for (const Method &method : all_methods)
  {
    const Forces reference = forces_by_pair(cells, identity, 0, method);
    Worst worst;
    std::vector<unsigned int> order = identity;
    std::mt19937 random(1);
    for (unsigned int k = 1; k < n_orders; ++k)
    {
      if (n_cells == 5)
        std::next_permutation(order.begin(), order.end());
      else
        std::shuffle(order.begin(), order.end(), random);
      worst.add(difference(reference, forces_by_pair(cells, order, k, method)));
    }
    check_error(std::to_string(n_orders) + " orders of " +
                    std::to_string(n_cells) + " cells, " + method.name,
                worst.error, 1e-8);
  }
}

void run()
{
  try_orders(5, 120);
  try_orders(300, 4);
}

const RoomTest test("numbering", run);
} // namespace test_numbering
