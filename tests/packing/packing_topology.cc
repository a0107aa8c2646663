// SPDX-License-Identifier: LGPL-2.1-or-later

// A packing of three cells with a T-junction, by hand: two unit squares side by
// side, and a 2 x 1 brick on top. Orientation, numbering, adjacency.

#include <voussoir/packing/connected_groups.h>

#include "tests.h"

namespace test_packing_topology
{
using namespace Voussoir;

CellLoops three_blocks()
{
  CellLoops cells;
  cells.vertices = {{0, 0}, {1, 0}, {2, 0}, {0, 1},
                    {1, 1}, {2, 1}, {0, 2}, {2, 2}};
  cells.loops = {0, 1, 4, 3, 1, 2, 5, 4, 3, 4, 5, 7, 6};
  cells.first = {0, 4, 8, 13};
  return cells;
}

void run()
{
  const Packing<2> packing(three_blocks());
  std::cout << packing.n_cells() << " cells, " << packing.interfaces().size()
            << " interfaces, " << packing.boundary_edges().size()
            << " boundary edges, static indeterminacy "
            << static_indeterminacy(packing, connected_groups(packing), 2)
            << std::endl;
  for (const auto &i : packing.interfaces())
    std::cout << i.cell_minus << " -> " << i.cell_plus << "  n = " << i.normal
              << "  t = " << i.tangent() << "  length " << i.length << "  at "
              << i.midpoint() << std::endl;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    std::cout << "cell " << c << ": centre " << packing.centre(c) << ", area "
              << packing.area(c) << ", sides " << packing.n_sides(c)
              << std::endl;

  // t_e runs from the start to the end of the edge, and each side of a cell is
  // the edge between its vertices.
  double error = 0.;
  for (const auto &i : packing.interfaces())
    error = std::max(error, (i.end - i.start - i.length * i.tangent()).norm());
  check_error("t_e along the edge", error, 1e-15);
  bool sides_fit = true;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    {
      const auto side = packing.sides(c)[i];
      const auto middle = side.on_boundary
                              ? packing.boundary_edges()[side.index].midpoint()
                              : packing.interfaces()[side.index].midpoint();
      sides_fit &= middle.distance(packing.vertex(c, i) +
                                   0.5 * (packing.vertex(c, i + 1) -
                                          packing.vertex(c, i))) < 1e-15;
    }
  check("sides follow the vertices", sides_fit);

  // Two cells that touch in a point only are two groups.
  CellLoops corner;
  corner.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  corner.loops = {0, 1, 2, 3, 2, 4, 5, 6};
  corner.first = {0, 4, 8};
  const Packing<2> two(corner);
  std::cout << "touching in a point: " << two.interfaces().size()
            << " interfaces, groups " << connected_groups(two)[0] << " and "
            << connected_groups(two)[1] << ", static indeterminacy "
            << static_indeterminacy(two, connected_groups(two), 2) << std::endl;
}

const RoomTest test("packing_topology", run);
} // namespace test_packing_topology
