// SPDX-License-Identifier: LGPL-2.1-or-later

// Coulomb's friction without dilatancy in space: a block in a groove and a rock
// wedge by their closed forms, which are other ones than with dilatancy; walls
// beside those in the plane; states and collapses judged by themselves.

#include <voussoir/analyses/factors/factor_without_dilatancy.h>
#include <voussoir/statics/energy/least_energy.h>

#include "extruded_scenes.h"

namespace test_space_coulomb
{
using namespace Voussoir;

const LeastEnergyInSpace &least_energy()
{
  static const LeastEnergyInSpace formulation;
  return formulation;
}

/** The factor without dilatancy, with what proves it for its own forces. */
FactorOf<SpaceScene> factor_of(const std::string &name,
                               SpaceCase of,
                               const SpaceLoads &dead,
                               const SpaceLoads &live,
                               const bool greatest = true)
{
  std::cout << name << std::endl;
  of.dilates = false;
  const auto blocks = of.blocks();
  const SpaceScene dead_scene(blocks, dead), live_scene(blocks, live);
  const auto answer = find_factor_without_dilatancy(
      dead_scene, live_scene, CoulombState(least_energy()), SolverControls(),
      {greatest}, Terminal::silent());
  check("  a factor", answer.factor.has_value());
  if (!answer.factor)
    return {};
  const FactorOf<SpaceScene> &found = *answer.factor;
  const SpaceScene at(blocks, together(dead, found.carried, live));
  check_error("  balance and limits", certify(at, found.forces).error(), 1e-9);
  check("  a collapse by its own forces", found.own_collapse.has_value());
  if (found.own_collapse)
  {
    const FactorBound own = bound_with_own_strengths(
        dead_scene, live_scene, found.forces, found.mechanism);
    check_error("  what its motion proves",
                std::abs(own.factor / found.carried - 1.), 1e-4);
    check_error("  joints close", own.closing_violation, 1e-10);
  }
  return found;
}

/** A prism along y in a groove of the half angle @p b, above z = 0. */
SpaceCase groove(const double b)
{
  CellFaces cells;
  const double w = std::tan(b);
  add_prism(cells, {{0., 0.}, {w, 1.}, {-w, 1.}}, -1., 0.);
  // (x, y, z) to (x, -z, y) keeps the orientation.
  cells = mapped(std::move(cells), [](const dealii::Point<3> &p) {
    return dealii::Point<3>(p[0], -p[2], p[1]);
  });
  SpaceCase of{Packing<3>(cells)};
  std::vector<bool> is_side;
  of.packing = Packing<3>(cells);
  for (const auto &face : of.packing.boundary_faces())
    is_side.push_back(face.normal[2] < -0.1);
  of.packing.support(is_side);
  return of;
}

void grooves()
{
  for (const bool turns : {false, true})
    for (const double b : {0.6, 1.})
    {
      SpaceCase of = groove(b);
      of.mu = 0.5;
      of.turns = turns;
      // Pushed at the height of the apex, so that it does not tilt.
      const double volume = of.packing.volume(0);
      SpaceLoads push(1);
      push.add(0, volume * vector(0., 1., 0.),
               turns ? dealii::Point<3>(0., of.packing.centre(0)[1], 0.) -
                           of.packing.centre(0)
                     : Vector3());
      const FactorOf<SpaceScene> found =
          factor_of(text("Groove", turns ? " of a block that may turn" : "",
                         ", angle ", b),
                    of, body_force(of.packing, vector(0., 0., -1.)), push);
      if (!turns)
        check_error("  mu / sin b",
                    std::abs(found.carried * std::sin(b) / of.mu - 1.), 1e-6);
    }
}

/** The unit normal out of a plane that dips, upwards; angles in degrees. */
Vector3 normal_of_plane(const double dip, const double direction)
{
  const double degree = std::acos(-1.) / 180.;
  return vector(std::sin(dip * degree) * std::sin(direction * degree),
                std::sin(dip * degree) * std::cos(direction * degree),
                std::cos(dip * degree));
}

/** The tetrahedron of four corners, in any order. */
void add_tetrahedron(CellFaces &cells, std::vector<dealii::Point<3>> corners)
{
  const auto arm = [&](const unsigned int k) {
    return corners[k] - corners[0];
  };
  if (cross_product_3d(arm(1), arm(2)) * arm(3) < 0.)
    std::swap(corners[2], corners[3]);
  for (const auto &corner : corners)
    cells.vertices.push_back(corner);
  for (const std::vector<unsigned int> &face :
       {std::vector<unsigned int>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
    cells.add_face(face);
  cells.end_cell();
}

/** A wedge on planes that dip by 40 and 60 degrees; the angle of friction. */
SpaceCase wedge(const double angle)
{
  const Vector3 a = normal_of_plane(40., 130.), b = normal_of_plane(60., 220.);
  // Along their line, downwards, from a point on the crest at the height one.
  Vector3 line = cross_product_3d(a, b);
  line *= (line[2] > 0. ? -1. : 1.) / line.norm();
  const auto on_crest = [](const Vector3 &n) {
    return vector(-n[1], n[0], 0.) / std::hypot(n[0], n[1]);
  };
  const dealii::Point<3> foot(line * (1. / -line[2]));
  std::vector<dealii::Point<3>> corners = {dealii::Point<3>(), foot};
  for (const Vector3 &n : {a, b})
  {
    // Horizontal in the plane, to the side of the foot's wedge.
    Vector3 side = on_crest(n);
    const Vector3 &other = (n - a).norm() < 1e-9 ? b : a;
    if (side * other < 0.)
      side *= -1.;
    corners.push_back(dealii::Point<3>(side * 1.5));
  }
  CellFaces cells;
  add_tetrahedron(cells, corners);
  SpaceCase of{Packing<3>(cells)};
  of.packing = Packing<3>(cells);
  std::vector<bool> is_base;
  for (const auto &face : of.packing.boundary_faces())
    is_base.push_back((face.normal + a).norm() < 1e-6 ||
                      (face.normal + b).norm() < 1e-6);
  of.packing.support(is_base);
  of.turns = false;
  of.mu = std::tan(angle * std::acos(-1.) / 180.);
  return of;
}

/**
 * The force along their line that holds the wedge takes from its weight alone
 * what friction has to bear: none is needed at the critical angle.
 */
void rock_wedge()
{
  const auto tangent = [](const double angle) {
    return std::tan(angle * std::acos(-1.) / 180.);
  };
  for (const double angle : {20., 30., 40.})
  {
    const SpaceCase of = wedge(angle);
    Vector3 line = cross_product_3d(normal_of_plane(40., 130.),
                                    normal_of_plane(60., 220.));
    line *= (line[2] > 0. ? 1. : -1.) / line.norm();
    const FactorOf<SpaceScene> found =
        factor_of(text("Rock wedge, friction of ", angle, " degrees"), of,
                  body_force(of.packing, vector(0., 0., -1.)),
                  body_force(of.packing, line), false);
    check_error("  the critical angle is 33.3572 degrees",
                std::abs(found.carried -
                         line[2] * (1. - tangent(angle) / tangent(33.3572))),
                1e-6);
  }
  std::cout << "Rock wedge with dilatancy" << std::endl;
  const auto is_carried = [](const double angle) {
    const SpaceCase of = wedge(angle);
    const SpaceScene scene(of.blocks(),
                           body_force(of.packing, vector(0., 0., -1.)));
    const DiscreteProblem problem = discretise(scene);
    const Solution found = find_space_state(
        problem, {}, LinearSolver::automatic, Terminal::silent());
    check("  an answer", found.converged() || found.mechanism);
    return found.converged();
  };
  check("  the critical angle is 31.0743 degrees",
        is_carried(31.0743 + 1e-4) && !is_carried(31.0743 - 1e-4));
}

/** Walls that are pushed over: as in the plane, times nothing. */
void walls()
{
  for (const unsigned int k : {0, 1})
  {
    Laws laws = {0., 0.65, 0., true, {}, {}};
    laws.dead[1] = -1.;
    laws.live[0] = 1.;
    const Packing<2> packing = on_foot(wall(4 + k, 3 + k, 2., 1.));
    const SpaceCase of = in_space(packing, laws);
    const FactorOf<SpaceScene> found = factor_of(
        text("Wall ", k), of, body_force(of.packing, upright(laws.dead)),
        body_force(of.packing, upright(laws.live)));
    Scene dead = scene_in_plane(packing, laws, laws.dead),
          live = scene_in_plane(packing, laws, laws.live);
    dead.dilates = live.dilates = false;
    const LeastEnergy in_plane;
    const auto plane = find_factor_without_dilatancy(
        dead, live, CoulombState(in_plane), SolverControls(),
        LoadFactorControls(), Terminal::silent());
    check_error("  beside the plane",
                std::abs(found.carried / plane.factor->carried - 1.), 1e-2);
  }
}

void run()
{
  grooves();
  rock_wedge();
  walls();
}

const RoomTest test("space_coulomb", run);
} // namespace test_space_coulomb
