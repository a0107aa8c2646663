// SPDX-License-Identifier: LGPL-2.1-or-later

// Cells that are no polygons, or convex ones around their centre, or do not
// fit, are refused with the cell, the place and what to do.

#include "tests.h"

namespace test_packing_failures
{
using namespace Voussoir;

void refuse(const std::vector<dealii::Point<2>> &vertices,
            const std::vector<dealii::Point<2>> &centres = {})
{
  CellLoops cells;
  cells.vertices = vertices;
  for (unsigned int v = 0; v < vertices.size(); ++v)
    cells.loops.push_back(v);
  cells.first.push_back(vertices.size());
  cells.centres = centres;
  show_refusal([&] { Packing<2> packing(cells); });
}

void run()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuse({{0, 0}, {1, 0}});
  refuse({{0, 0}, {0, 1}, {1, 1}, {1, 0}});
  refuse({{0, 0}, {1, 0}, {2, 0}});
  refuse({{0, 0}, {1, 0}, {nan, 1}});
  refuse({{0, 0}, {1, 0}, {1, 0}, {0, 1}});
  refuse({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{2, 0.5}});

  // A pentagram: every corner turns left, but the loop winds twice.
  std::vector<dealii::Point<2>> star;
  for (unsigned int i = 0; i < 5; ++i)
    star.emplace_back(std::cos(0.8 * dealii::numbers::PI * i),
                      std::sin(0.8 * dealii::numbers::PI * i));
  refuse(star);

  // The same square twice, and three cells on one edge.
  CellLoops cells;
  cells.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cells.loops = {0, 1, 2, 3, 0, 1, 2, 3};
  cells.first = {0, 4, 8};
  show_refusal([&] { Packing<2> packing(cells); });
}

const RoomTest test("packing_failures", run);
} // namespace test_packing_failures
