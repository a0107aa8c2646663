// SPDX-License-Identifier: LGPL-2.1-or-later

// Capacity curves: a block, a column of ten and a parapet that rock about an
// edge of their foot against tan(b - theta), at any displacement; an arch whose
// hinges go from joint to joint against itself with steps of other sizes; a
// block and an arch on supports that turn. At
// each position forces carry the factor and a mechanism bounds it. Moved scenes
// have the loads of the scene at rest.

#include <voussoir/analyses/capacity/capacity_curve.h>
#include <voussoir/base/geometry.h>
#include <voussoir/scene/positions.h>

#include "tests.h"

namespace test_capacity
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

CapacityCurve curve_of(const Packing<2> &packing,
                       const unsigned int cell,
                       const Point<2> &place,
                       const unsigned int n_points,
                       const std::vector<SupportMotion> &of_supports = {})
{
  const Scene dead = under_weight(packing, 0., 3., rotations());
  const Scene live =
      under_weight(packing, 0., 3., rotations(), Tensor<1, 2>({1., 0.}));
  CapacityWanted wanted = {cell,     place, Tensor<1, 2>({1., 0.}),
                           n_points, 0.,    of_supports};
  return find_capacity(dead, live, wanted, {}, Terminal::silent()).curve;
}

/** Both proofs, at each point but the first, whose tolerance is the usual. */
void check_proofs(const std::string &what, const CapacityCurve &curve)
{
  double states = 0., width = 0.;
  for (const CapacityPoint &point : curve.points)
  {
    states = std::max(states, point.error_of_state);
    width = std::max(width, std::abs(point.bound - point.carried));
  }
  check_error(what + ": states", states, 1e-12);
  check_error(what + ": width", width, 1e-9);
}

/** Blocks of width b and height h in all turn as one about a corner. */
void rocks(const std::string &what,
           const Packing<2> &packing,
           const double b,
           const double h)
{
  const unsigned int top = packing.n_cells() - 1;
  const Point<2> place(0., h);
  const CapacityCurve curve = curve_of(packing, top, place, 15);
  const double slope = std::atan2(b, h);
  double error = 0.;
  for (const CapacityPoint &point : curve.points)
  {
    // b + displacement = sqrt(b^2 + h^2) sin(theta + the angle of -b / h)
    const double turn =
        std::asin((point.displacement - b) / std::hypot(b, h)) + slope;
    error = std::max(error, std::abs(point.carried - std::tan(slope - turn)));
  }
  check(what + ": there are many positions", curve.points.size() > 10);
  check_error(what + ": the factor at each", error, 1e-9);
  check_error(what + ": it ends where the top has gone by the thickness",
              std::abs(curve.ultimate / b - 1.), 1e-8);
  check_proofs(what, curve);
}

void arch()
{
  Packing<2> ring = on_ground(semicircle(25, 0.2));
  const CapacityCurve few = curve_of(ring, 12, Point<2>(0., 1.), 10);
  const CapacityCurve many = curve_of(ring, 12, Point<2>(0., 1.), 40);
  check_error("an arch: the end with few and many steps",
              std::abs(few.ultimate / many.ultimate - 1.), 1e-6);
  check_proofs("an arch", many);
  bool falls = true;
  for (std::size_t k = 1; k < many.points.size(); ++k)
    falls &= many.points[k].carried < many.points[k - 1].carried;
  check("an arch: the factor only falls", falls);
}

/** A block on ground that tilts by an angle t: tan(b - t), until it falls. */
void tilts()
{
  const double slope = std::atan(1. / 3.);
  const auto tilted_by = [&](const double angle) {
    return curve_of(on_ground(wall(1, 1, 1., 3.)), 0, Point<2>(0., 3.), 20,
                    {{Tensor<1, 2>(), -angle}});
  };
  const CapacityCurve curve = tilted_by(0.2);
  double error = 0., of_point = 0.;
  for (const CapacityPoint &point : curve.points)
  {
    const double turn = 2. * std::asin(point.of_supports);
    error = std::max(error, std::abs(point.carried - std::tan(slope - turn)));
    const double x = 0.5 - 0.5 * std::cos(turn) + 3. * std::sin(turn);
    of_point = std::max(of_point, std::abs(point.displacement - x));
  }
  check_error("on ground that tilts: the factor at each", error, 1e-9);
  check_error("on ground that tilts: the point", of_point, 1e-12);
  check_error("on ground that tilts: by the whole angle",
              std::abs(curve.points.back().of_supports - std::sin(0.1)), 1e-12);
  std::cout << curve.end << std::endl;
  const CapacityCurve fall = tilted_by(0.5);
  check_error("it falls where its centre is above its edge",
              std::abs(fall.points.back().of_supports - std::sin(slope / 2.)),
              1e-9);
  std::cout << fall.end << std::endl;
}

/** An arch whose support goes and turns, in steps of other sizes. */
void turning_springing()
{
  const Packing<2> ring = on_ground(semicircle(20, 0.3));
  const std::vector<SupportMotion> of_supports = {
      {}, {Tensor<1, 2>({0.05, -0.03}), -0.04}};
  const CapacityCurve few =
      curve_of(ring, 10, Point<2>(-0.05, 1.), 5, of_supports);
  const CapacityCurve many =
      curve_of(ring, 10, Point<2>(-0.05, 1.), 40, of_supports);
  std::cout << few.end << std::endl << many.end << std::endl;
  const CapacityPoint &a = few.points.back(), &b = many.points.back();
  check("a springing that turns: few and many steps",
        few.points.size() < 10 && many.points.size() > 30);
  check_error("a springing that turns: the point",
              std::abs(a.displacement - b.displacement), 1e-9);
  check_error("a springing that turns: the factor",
              std::abs(a.carried - b.carried), 1e-8);
  check_error("a springing that turns: the force of the support",
              std::abs(a.support_force - b.support_force), 1e-9);
  check_error("a springing that turns: and its proof",
              std::abs(b.support_force - b.least_support_force), 1e-12);
  check_proofs("a springing that turns", many);
}

/** Loads of all kinds on random cells, anywhere. */
void moved()
{
  const Packing<2> packing = random_packing(30, 4);
  Loads loads;
  for (const auto &edge : packing.boundary_edges())
    loads.traction.push_back(
        Point<2>(edge.midpoint()[1] - 0.3, edge.normal[0]));
  Tensor<1, 2> sum;
  for (unsigned int b = 0; b < loads.traction.size(); ++b)
    sum += packing.boundary_edges()[b].length * loads.traction[b];
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    loads.body.add(packing, c, -packing.area(c) * sum);
  const Scene at_rest(packing,
                      std::vector<double>(packing.interfaces().size(), 1.),
                      loads, translations());
  Positions positions(packing.n_cells());
  Motion motion(packing.n_cells(), rotations());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    motion.displacement[c] = Point<2>(0.3, -2.);
    motion.rotation[c] = 0.7;
  }
  // All as one about the origin.
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    const Point<2> &x = packing.centre(c);
    const double s = std::sin(0.7), k = std::cos(0.7);
    motion.displacement[c] =
        Point<2>(k * x[0] - s * x[1] - x[0], s * x[0] + k * x[1] - x[1]);
  }
  positions = positions.advanced(motion, 1.);
  double apart = 0.;
  for (const MovedJoint &joint : moved_joints(packing, positions))
    apart = std::max({apart, std::abs(joint.openings[0]),
                      std::abs(joint.openings[1]), std::abs(joint.sliding)});
  check_error("cells that move as one body do not part", apart, 1e-14);
  const Scene there =
      moved_scene(at_rest, positions,
                  std::vector<std::array<bool, 2>>(packing.interfaces().size(),
                                                   {{false, false}}));
  double of_loads = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    of_loads = std::max(of_loads, (there.load[c] - at_rest.load[c]).norm());
  check_error("loads stay as they are", of_loads, 1e-14);
  // The moment about the origin of loads that keep their directions.
  Resultant before({0., 0.}), after({0., 0.});
  for (unsigned int b = 0; b < loads.traction.size(); ++b)
  {
    const auto turn = [](const Point<2> &x) {
      return Point<2>(std::cos(0.7) * x[0] - std::sin(0.7) * x[1],
                      std::sin(0.7) * x[0] + std::cos(0.7) * x[1]);
    };
    const auto &edge = packing.boundary_edges()[b];
    before.add(turn(edge.midpoint()), edge.length * loads.traction[b]);
    const auto &moved = there.packing.boundary_edges()[b];
    after.add(moved.midpoint(), moved.length * there.traction[b]);
  }
  check_error("at the same points", std::abs(before.moment() - after.moment()),
              1e-13);
}

/** Forces in a block, a couple among them, and the weight, on one that turns.
 */
void turned_loads()
{
  const Packing<2> packing = on_ground(wall(1, 1, 1., 2.));
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  const Point<2> centre(0.5, 1.);
  const std::vector<std::pair<Point<2>, Tensor<1, 2>>> forces = {
      {Point<2>(0.1, 1.8), Point<2>(2., -1.)},
      {Point<2>(0.7, 0.3), Point<2>(-2., 1.)}};
  for (const auto &[place, force] : forces)
    loads.on_cells.push_back({"cell 0", {0}, force, place});
  const Scene at_rest(packing, {1.}, loads, rotations());
  Positions positions(1);
  positions.angle[0] = 0.4;
  double torque = 0.;
  for (const auto &[place, force] : forces)
    torque += cross(rotation_by(0.4) * (place - centre), force);
  const Scene there = moved_scene(at_rest, positions, {{{false, false}}});
  check_error("a couple of forces that keep their directions",
              std::abs(there.load_torque[0] - torque), 1e-14);
  check_error(
      "with other loads beside",
      std::abs(moved_scene(at_rest, positions, {{{false, false}}}, &at_rest, 2.)
                   .load_torque[0] -
               3. * torque),
      1e-14);
}

/** An open end bears nothing, and resists nothing. */
void open_ends()
{
  Scene scene = under_weight(on_ground(wall(1, 1)), 1., 0.5, rotations());
  scene.open_ends = {{{true, false}}};
  InterfaceForces forces = no_forces(scene);
  forces.normal[0] = -1.;
  forces.at_ends = {{{0., -1.}}};
  check_error("a force at the other end",
              certify(scene, forces).admissibility_violation, 1e-15);
  forces.at_ends = {{{-0.25, -0.75}}};
  check_error("is seen at the open one",
              std::abs(certify(scene, forces).admissibility_violation - 0.25),
              1e-15);
  forces.at_ends = {{{0., -1.}}};
  forces.tangential[0] = 0.6;
  check_error("and friction without cohesion",
              std::abs(certify(scene, forces).admissibility_violation - 0.1),
              1e-15);
  // It turns about its right edge, into the open end, for the work of nothing.
  Motion closes(1, rotations());
  closes.rotation[0] = 1.;
  closes.displacement[0] = Point<2>(-0.5, -0.5);
  const MechanismCertificate proof = certify_mechanism(scene, closes);
  check("an open end may close",
        proof.closing_violation < 1e-15 && proves_collapse(proof));
}

void run()
{
  turned_loads();
  open_ends();
  rocks("a block", on_ground(wall(1, 1, 1., 3.)), 1., 3.);
  rocks("a column of ten", on_ground(stack_of_squares(10)), 1., 10.);
  arch();
  tilts();
  turning_springing();
  moved();
  const Packing<2> block = on_ground(wall(1, 1));
  show_refusal([&] {
    const Scene dead = under_weight(block, 0., 3., rotations());
    const Scene live =
        under_weight(block, 0., 3., rotations(), Tensor<1, 2>({-1., 0.}));
    find_capacity(dead, live,
                  {0, Point<2>(0.5, 0.5), Tensor<1, 2>({1., 0.}), 5, 0.}, {},
                  Terminal::silent());
  });
  show_refusal([&] {
    const Scene dead = under_weight(block, 0., 0.2, rotations());
    const Scene live =
        under_weight(block, 0., 0.2, rotations(), Tensor<1, 2>({1., 0.}));
    find_capacity(dead, live,
                  {0, Point<2>(0.5, 0.5), Tensor<1, 2>({1., 0.}), 5, 0.}, {},
                  Terminal::silent());
  });
}

const RoomTest test("capacity", run);
} // namespace test_capacity
