// SPDX-License-Identifier: LGPL-2.1-or-later

// Hard contact comes out at a point of the central path and not near it: forces
// do not change when the packing is moved by a million cells, nor with the
// solver's tolerance. The coordinates are multiples of 2^-30 and the move is a
// power of two, so that both packings are the same to the last digit.

#include "tests.h"

namespace test_hard_contact_translated
{
using namespace Voussoir;
using dealii::Point;

CellLoops moved(CellLoops cells, const double distance)
{
  const double unit = std::ldexp(1., -30);
  for (Point<2> &x : cells.vertices)
    x = Point<2>(unit * std::round(x[0] / unit) + distance,
                 unit * std::round(x[1] / unit) + distance);
  for (Point<2> &x : cells.centres)
    x = Point<2>(unit * std::round(x[0] / unit) + distance,
                 unit * std::round(x[1] / unit) + distance);
  return cells;
}

void run()
{
  for (const unsigned int seed : {1u, 2u, 3u, 4u})
  {
    const CellLoops cells = voronoi_cells(
        random_points(60, seed, {{0., 0.}, {1., 1.}}), {{0., 0.}, {1., 1.}});
    const auto scene = [&](const double distance) {
      return scene_under_stress(Packing<2>(moved(cells, distance)), 10.,
                                tensor(-1., 0., 0., -1.));
    };
    const Scene near = scene(0.), far = scene(std::ldexp(1., 17));
    const InterfaceForces forces = Solver(hard).forces(near);
    check_error("moved by a million cells: change of the forces",
                distance(forces, Solver(hard).forces(far)), 1e-8);
    check_error("tolerance 1e-14: change of the forces",
                distance(forces, Solver(hard, 1e-14).forces(near)), 1e-8);
    check_error("residual", certify(near, forces).equilibrium_residual, 1e-10);
  }
}

const RoomTest test("hard_contact_translated", run);
} // namespace test_hard_contact_translated
