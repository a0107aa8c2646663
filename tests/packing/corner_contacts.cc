// SPDX-License-Identifier: LGPL-2.1-or-later

// Corners that touch a side in a point get a joint, as good as without length:
// a diamond that stands on its tip is in balance, a plank on two edges tips
// where statics say, and areas stay; all others, and a running bond, are left
// alone.

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/base/geometry.h>
#include <voussoir/packing/polygons/corner_contacts.h>
#include <voussoir/packing/polygons/matching.h>

#include "polygons.h"
#include "tests.h"

namespace test_corner_contacts
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

using Ring = std::vector<Point<2>>;

Packing<2> packing_of(const std::vector<Ring> &rings)
{
  PolygonList polygons = list_of(rings);
  CellLoops cells = match_polygons(polygons, 1e-10);
  join_corners(cells);
  for (const std::string &notice : cells.notices)
    std::cout << notice << std::endl;
  return Packing<2>(std::move(cells));
}

/** A force on one cell, at a place. */
Scene scene_of(const Packing<2> &packing,
               const unsigned int cell,
               const Tensor<1, 2> &force,
               const Point<2> &place,
               const double mu)
{
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  loads.body.add(packing, cell, force);
  Scene scene(packing, std::vector<double>(packing.interfaces().size(), 0.),
              loads, rotations());
  scene.load_torque[cell] += cross(place - packing.centre(cell), force);
  if (mu > 0.)
    scene.coefficient.assign(packing.interfaces().size(), mu);
  return scene;
}

void diamond()
{
  std::cout << "A diamond on its tip" << std::endl;
  const Packing<2> packing = on_ground(
      packing_of({rectangle(0, 0, 4, 1), {{2, 1}, {3, 2}, {2, 3}, {1, 2}}}));
  check("a joint and the ground", packing.interfaces().size() == 2);
  check_error("areas", std::abs(packing.area() - 6.), 1e-11);
  const Packing<2>::Interface &tip = packing.interfaces()[0];
  check_error("where they touch", tip.midpoint().distance({2., 1.}), 1e-5);
  check_error("its normal", std::abs(tip.normal[0]), 1e-9);
  const Scene scene =
      scene_of(packing, 1, Tensor<1, 2>({0., -1.}), {2., 2.}, 0.);
  const InterfaceForces forces = Solver(least_energy).forces(scene);
  check_error("balance", certify(scene, forces).error(), 1e-10);
  check_error("its weight", std::abs(forces.normal[0] + 1.), 1e-10);
}

void plank()
{
  std::cout << "A plank on two edges, loaded at its end" << std::endl;
  const Packing<2> packing = on_ground(packing_of({{{0.5, 0}, {1.5, 0}, {1, 1}},
                                                   {{2.5, 0}, {3.5, 0}, {3, 1}},
                                                   rectangle(0, 1, 4, 0.2)}));
  check("two joints on the edges", packing.interfaces().size() == 4);
  const LoadFactorAnswer answer = find_load_factor(
      scene_of(packing, 2, Tensor<1, 2>({0., -1.}), {2., 1.1}, 0.5),
      scene_of(packing, 2, Tensor<1, 2>({0., -1.}), {0., 1.1}, 0.5), {},
      Terminal::silent());
  // It tips about the edge at 1, as far from the one load as from the other.
  check_error("factor", std::abs(answer.factor->carried - 1.), 1e-5);
}

void others()
{
  std::cout << "Corner to corner" << std::endl;
  check("no joint", packing_of({rectangle(0, 0, 1, 1), rectangle(1, 1, 1, 1)})
                        .interfaces()
                        .empty());
  std::cout << "Two tips at one point of a side" << std::endl;
  check("no joint", packing_of({rectangle(0, 0, 4, 1),
                                {{2, 1}, {1.5, 2}, {1, 2}},
                                {{2, 1}, {3, 2}, {2.5, 2}}})
                        .interfaces()
                        .empty());
  std::cout << "Running bond" << std::endl;
  check("its beds", packing_of({rectangle(0, 0, 2, 1), rectangle(2, 0, 2, 1),
                                rectangle(1, 1, 2, 1), rectangle(3, 1, 1, 1)})
                            .interfaces()
                            .size() == 5);
}

void run()
{
  diamond();
  plank();
  others();
}

const RoomTest test("corner_contacts", run);
} // namespace test_corner_contacts
