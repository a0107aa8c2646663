// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks of all kinds, given in either orientation: volumes in closed form, and
// faces outwards.

#include <voussoir/packing/polyhedra/generators/block_builder.h>

#include "block_checks.h"

namespace test_block_builder
{
using namespace Voussoir;
using Point = dealii::Point<3>;
using Loop = BlockBuilder::Loop;

/** The mirror image, which turns the orientation. */
Loop mirrored(Loop loop)
{
  for (Point &p : loop)
    p[0] = -p[0];
  return loop;
}

void check_volume(const std::string &name, BlockBuilder &blocks, const double v)
{
  std::cout << name << std::endl;
  check("  two blocks", blocks.n_blocks() == 2);
  const CellFaces cells = blocks.take();
  check("  none remains", blocks.n_blocks() == 0);
  bool closed = true;
  double error = 0.;
  for (unsigned int c = 0; c < 2; ++c)
  {
    closed &= open_edges(cells, c).empty();
    error = std::max(error, std::abs(moments_of(cells, c).volume - v));
  }
  check("  closed", closed);
  check_error("  volumes", error, 1e-15);
  check("  of the second group",
        cells.group == std::vector<unsigned int>(2, 1U) &&
            cells.group_names == std::vector<std::string>({"a", "b"}));
  const Box3 box(cells.vertices);
  check_error("  tolerance",
              std::abs(cells.tolerance /
                           std::max({box.side_length(0), box.side_length(1),
                                     box.side_length(2)}) -
                       1e-9),
              1e-20);
}

void run()
{
  const std::vector<std::string> groups = {"a", "b"};

  BlockBuilder boxes(groups);
  boxes.reserve_boxes(2);
  boxes.add_box({1., 2., 3.}, {3., 5., 4.}, 1);
  boxes.add_box({-1., 2., 3.}, {-3., 5., 4.}, 1);
  check_volume("boxes", boxes, 6.);

  const Loop low = {{0., 0., 0.}, {2., 0., 0.}, {0., 2., 0.}};
  const Loop high = {{0., 0., 3.}, {1., 0., 3.}, {0., 1., 3.}};
  BlockBuilder frusta(groups);
  frusta.add_frustum(low, high, 1);
  frusta.add_frustum(mirrored(low), mirrored(high), 1);
  check_volume("frusta", frusta, 3. * (2. + 0.5 + 1.) / 3.);

  // Wedges 2 long below and 1 above, 1 wide and 1 high.
  std::array<Point, 8> wedge;
  for (unsigned int i = 0; i < 8; ++i)
    wedge[i] = Point(i % 2 * (i < 4 ? 2. : 1.), i / 2 % 2, i / 4);
  BlockBuilder wedges(groups);
  wedges.add_hexahedron(wedge, 1);
  for (Point &p : wedge)
    p[0] = -p[0];
  wedges.add_hexahedron(wedge, 1);
  check_volume("hexahedra", wedges, 1.5);

  // An L of three unit cubes, which is not convex.
  Loop corners;
  const Loop ell = {{0., 0., 0.}, {2., 0., 0.}, {2., 1., 0.},
                    {1., 1., 0.}, {1., 2., 0.}, {0., 2., 0.}};
  std::vector<std::vector<unsigned int>> faces(2);
  for (const double z : {0., 1.})
    for (const Point &p : ell)
      corners.emplace_back(p[0], p[1], z);
  for (unsigned int i = 0; i < 6; ++i)
  {
    const unsigned int next = (i + 1) % 6;
    faces[0].push_back(5 - i);
    faces[1].push_back(6 + i);
    faces.push_back({i, next, 6 + next, 6 + i});
  }
  BlockBuilder ells(groups);
  ells.add_polyhedron(corners, faces, 1);
  ells.add_polyhedron(mirrored(corners), faces, 1);
  check_volume("polyhedra", ells, 3.);

  BlockBuilder none(groups);
  check("no blocks", none.take().n_cells() == 0);
}

const RoomTest test("block_builder", run);
} // namespace test_block_builder
