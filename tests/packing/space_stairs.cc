// SPDX-License-Identifier: LGPL-2.1-or-later

// Cantilevered stairs: volumes and areas of contact of the steps in closed
// form, steps that fill the holes of the wall; failures.

#include <voussoir/packing/polyhedra/generators/stairs.h>

#include "block_checks.h"

namespace test_space_stairs
{
using namespace Voussoir;

CellFaces generate(const std::string &settings)
{
  return generated<StairsGenerator>(
      "set Going = 0.28\nset Rise = 0.17\nset Width = 1\nset Overlap = 0.03\n"
      "set Bearing = 0.16\nset Wall thickness = 0.3\nset Brick length = 0.5\n"
      "set Wall ends = 0.4\nset Courses above = 3\n" +
      settings);
}

void check_stairs(const unsigned int n, const double bearing)
{
  std::cout << n << " steps, " << bearing << " in the wall" << std::endl;
  const CellFaces cells =
      generate(text("set Steps = ", n, "\nset Bearing = ", bearing));
  const double length = 0.28 * n + 0.03 + 0.8;
  check_blocks(cells, length * 0.3 * 0.17 * (n + 3) + n * 0.31 * 0.17 * 1.);
  const std::vector<Box3> boxes = boxes_of(cells);
  const auto areas = check_contacts(cells);
  std::vector<Box3> steps, bricks;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    (cells.group_names[cells.group[c]] == "step" ? steps : bricks)
        .push_back(boxes[c]);
  check("  steps", steps.size() == n);
  check_error(
      "  areas between steps",
      std::abs(area_between(steps, 2) - (n - 1) * 0.03 * (1. + bearing)),
      1e-14);
  check("  no faces between steps but those",
        area_between(steps, 0) == 0. && area_between(steps, 1) == 0.);
  // All of a step in the wall but its front touches bricks or other steps.
  check_error("  areas of beds",
              std::abs(areas[2] - length * 0.3 * (n + 2) - (n - 1) * 0.03),
              1e-13);
  check_error("  areas of backs",
              std::abs(areas[1] - (bearing < 0.3 ? n * 0.31 * 0.17 : 0.)),
              1e-14);
  check_error(
      "  areas of sides",
      std::abs(areas[0] - area_between(bricks, 0) - 2. * n * 0.17 * bearing),
      1e-13);
  double shortest = length;
  for (const Box3 &brick : bricks)
    shortest = std::min(shortest, brick.side_length(0));
  check("  no slivers", shortest >= 0.0625);
}

void refuse(const std::string &settings)
{
  show_refusal([&] { generate(settings); });
}

void run()
{
  check_stairs(1, 0.16);
  check_stairs(10, 0.16);
  check_stairs(7, 0.3);
  // A wall that ends with the flight has bricks before and behind it still.
  const CellFaces flush = generate("set Wall ends = 0\nset Courses above = 0");
  check_error(
      "a wall that ends with the flight",
      std::abs(volume_of(flush) - (10. * 2.83 * 0.3 + 10. * 0.31) * 0.17),
      1e-12);

  refuse("set Going = 0");
  refuse("set Bearing = 0.31");
  refuse("set Wall ends = 0.05");
  refuse("set Brick length = 1e-9");
}

const RoomTest test("space_stairs", run);
} // namespace test_space_stairs
