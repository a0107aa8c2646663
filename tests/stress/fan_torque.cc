// SPDX-License-Identifier: LGPL-2.1-or-later

// A unit square with a unit shear on its top and bottom alone: the forces
// balance, their torque of -1 about the centre does not. Then no symmetric
// stress is free of divergence; the mixed problem keeps the symmetry in the
// mean of each sub-cell, and what it leaves of div sigma has no resultant and
// takes up the torque. A sliver around its centre has no unique answer.

#include <voussoir/stress/fan.h>

#include "tests.h"

namespace test_fan_torque
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

void run()
{
  const std::vector<Point<2>> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Point<2> centre(0.5, 0.5);
  std::vector<Tensor<1, 2>> forces(4);
  const std::vector<Tensor<1, 2>> no_body_force(4);
  forces[0][0] = -1.;
  forces[2][0] = 1.;

  Fan fan(4);
  std::vector<SubCellStress> sub_cells(4);
  const bool unique =
      fan.solve({centre, square, forces, no_body_force},
                dealii::ArrayView<SubCellStress>(sub_cells.data(), 4));
  check("a unique answer", unique);

  Tensor<1, 2> resultant;
  double skew = 0., torque = 0.;
  for (unsigned int i = 0; i < 4; ++i)
  {
    // Each triangle has the area 1/4; x is the centroid of the sub-cell, and
    // div sigma varies as 1/det J, which weighs the reference square evenly.
    const double area = 0.25;
    const auto corners = SubTriangulation::fan().corners(0, centre, square[i],
                                                         square[(i + 1) % 4]);
    Tensor<1, 2> arm;
    for (const auto &corner : corners)
      arm += 0.25 * (corner - centre);
    const Tensor<1, 2> force = area * sub_cells[i].divergence;
    resultant += force;
    torque += arm[0] * force[1] - arm[1] * force[0];
    skew = std::max(
        skew, std::abs(sub_cells[i].stress[0][1] - sub_cells[i].stress[1][0]));
  }
  check_error("skew part", skew, 1e-13);
  check_error("resultant of div sigma", resultant.norm(), 1e-13);
  check_error("torque of div sigma + 1", std::abs(torque + 1.), 1e-13);

  // Without torque the same cell is free of divergence.
  forces[1][1] = 1.;
  forces[3][1] = -1.;
  fan.solve({centre, square, forces, no_body_force},
            dealii::ArrayView<SubCellStress>(sub_cells.data(), 4));
  double divergence = 0.;
  for (const auto &sub_cell : sub_cells)
    divergence = std::max(divergence, sub_cell.divergence.norm());
  check_error("div sigma without torque", divergence, 1e-13);

  // A centre so close to a side that rounding decides.
  const Point<2> edge(0.5, 1e-15);
  const auto before = sub_cells;
  const bool degenerate =
      fan.solve({edge, square, forces, no_body_force},
                dealii::ArrayView<SubCellStress>(sub_cells.data(), 4));
  double change = 0.;
  for (unsigned int i = 0; i < 4; ++i)
    change += (sub_cells[i].stress - before[i].stress).norm();
  check("no answer where there is none", !degenerate);
  check_error("the result is left alone", change, 0.);
}

const RoomTest test("fan_torque", run);
} // namespace test_fan_torque
