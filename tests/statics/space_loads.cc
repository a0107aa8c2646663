// SPDX-License-Identifier: LGPL-2.1-or-later

// Loads in space: tractions and body forces by expressions, with their moments,
// against closed forms; point loads; strengths by expressions; certificates
// that notice planted errors; and the words for what is refused.

#include <voussoir/scene/space/space_loads.h>

#include "space_scenes.h"

namespace test_space_loads
{
using namespace Voussoir;

/** Two bricks side by side, 2 x 1 x 1 each, on z = 0. */
SpaceCase two_bricks()
{
  return SpaceCase(Packing<3>(brick_wall(2, 1, 1)));
}

/** The loads of some entries "name = value". */
SpaceLoads loads_of(const Packing<3> &packing,
                    const std::vector<std::pair<std::string, std::string>> &set,
                    std::vector<std::string> *const warnings = nullptr)
{
  SpaceLoadParameters parameters;
  dealii::ParameterHandler prm;
  parameters.add_parameters(prm);
  prm.enter_subsection("Loads");
  for (const auto &[name, value] : set)
    prm.set(name, value);
  prm.leave_subsection();
  std::vector<std::string> here;
  SpaceLoads loads = parameters.loads(packing, warnings ? *warnings : here);
  return loads;
}

void check_vector(const std::string &what,
                  const Vector3 &found,
                  const Vector3 &expected,
                  const double error = 1e-12)
{
  check_error(what, (found - expected).norm(), error);
}

void closed_forms()
{
  const Packing<3> packing = two_bricks().packing;
  // Bricks 2 x 1 x 0.5 with the centres (1, 0.5, 0.25) and (3, 0.5, 0.25).
  SpaceLoads loads = loads_of(packing, {{"Body force", "0; 0; -x"}});
  check_vector("body force: force", loads.force[1], vector(0., 0., -3.));
  // -int (x - 3) x = -int (x - 3)^2 = -2/3 times 0.5, along -y.
  check_vector("  moment", loads.torque[1], vector(0., 1. / 3., 0.));
  loads = loads_of(packing,
                   {{"Traction", "0; 0; -y^2 * x"}, {"Where", "nz > 0.5"}});
  check_vector("traction: force", loads.force[0], vector(0., 0., -2. / 3.));
  // Arms from the centre: y - 1/2 and x - 1.
  check_vector("  moment", loads.torque[0],
               vector(-2. * (1. / 4. - 1. / 6.), (8. / 3. - 2.) / 3., 0.));
  std::vector<std::string> warnings;
  loads = loads_of(
      packing, {{"Traction", "0; 0; x < 0.7 ? -1 : 0"}, {"Where", "nz > 0.5"}},
      &warnings);
  check_vector("traction with a jump", loads.force[0], vector(0., 0., -0.7),
               2e-3);
  check("  and a warning", warnings.size() == 1);
  loads = loads_of(packing, {{"Boundary load", "uniform stress"},
                             {"Stress", "1, 0, 2; 0, 0, 0; 2, 0, -3"}});
  Vector3 sum;
  for (const Vector3 &force : loads.force)
    sum += force;
  // All but what rests on the ground, of the area 4.
  check_vector("uniform stress", sum, -vector(-8., 0., 12.));
  loads = loads_of(packing, {{"Cell forces", "at 1, 1, 0.5: 0, 3, 0 | cell 1: "
                                             "1, 0, 0 at 4, 0, 0.5"}});
  check_vector("point load: force", loads.force[0], vector(0., 3., 0.));
  check_vector("  moment", loads.torque[0], vector(-0.75, 0., 0.));
  check_vector("  of a cell", loads.torque[1], vector(0., 0.25, 0.5));
  loads = loads_of(packing, {{"Body force", "0; 0; -1"},
                             {"Group body forces", "cell 1: 0; 0; -5"}});
  check_vector("of cells", loads.force[0] + loads.force[1],
               vector(0., 0., -6.));
}

void refusals()
{
  const Packing<3> packing = two_bricks().packing;
  const auto refuse = [&](const std::string &name, const std::string &value) {
    show_refusal([&] { loads_of(packing, {{name, value}}); });
  };
  refuse("Body force", "0; 0; 1/(x-x)");
  refuse("Traction", "0; 0; nw");
  refuse("Group body forces", "cell 1: 0; -5");
  refuse("Group body forces", "cell 1: 0; 0; -5 | cell 1: 0; 0; 1");
  refuse("Group body forces", "ground: 0; 0; -5");
  refuse("Cell forces", "at 1, 1, 3: 0, 3, 0");
  refuse("Cell forces", "at 1, 1: 0, 3, 0");
  refuse("Cell forces", "cell 1: 0, 3");
  refuse("Cell forces", "cell 1: 0, 3, 0 at 0, 0, 0");
  refuse("Cell forces", "block: 0, 3, 0 at 0, 0, 0");
  refuse("Cell forces", "ground: 0, 3, 0");
  show_refusal([&] {
    loads_of(packing, {{"Traction", "1; 0; 0"}, {"Where", "z > 7"}});
  });
  show_refusal([&] {
    loads_of(packing, {{"Boundary load", "uniform stress"},
                       {"Stress", "1, 0, 2; 0, 0, 0; 1, 0, -3"}});
  });
  // What nothing supports.
  SpaceCase floating = two_bricks();
  floating.packing = Packing<3>(brick_wall(2, 1, 1));
  for (const bool turns : {false, true})
  {
    floating.turns = turns;
    show_refusal([&] {
      SpaceLoads loads(2);
      loads.add(0, vector(0., 0., 1.), Vector3());
      if (turns)
        loads.add(0, vector(0., 0., -1.), vector(1., 0., 0.));
      SpaceScene(floating.blocks(), loads);
    });
  }
  show_refusal([&] {
    SpaceLoads loads(2);
    loads.add(0, vector(0., 0., 1e200), Vector3());
    SpaceScene(two_bricks().blocks(), loads);
  });
}

void planted_errors()
{
  SpaceCase bricks = two_bricks();
  bricks.mu = 0.5;
  bricks.strength = 0.1;
  const SpaceScene scene(bricks.blocks(),
                         body_force(bricks.packing, vector(0.1, 0., -1.)));
  const FaceForces good = elastic_forces(scene);
  check_error("a state", certify(scene, good).error(), 1e-12);
  FaceForces forces = good;
  forces.list[0].force += vector(0., 0., 1e-3);
  check("a force more: balance",
        certify(scene, forces).equilibrium_residual > 9e-4);
  forces = good;
  forces.list[0].force += vector(0., 0., 1e-3);
  forces.list[1].force -= vector(0., 0., 1e-3);
  check("a couple: moment", certify(scene, forces).moment_residual > 9e-4);
  check("  not balance", certify(scene, forces).equilibrium_residual < 1e-12);
  // At the supports: the pressure of one corner turned into tension.
  const unsigned int support = bricks.packing.interfaces().size() - 1;
  forces = good;
  forces.list[forces.first[support]].force = vector(0., 0., -1e-3);
  check("tension: limit",
        certify(scene, forces).admissibility_violation > 9e-4);
  forces = good;
  forces.list[forces.first[support]].force += vector(0., 1., 0.);
  check("shear: limit", certify(scene, forces).admissibility_violation > 0.4);
  forces.list[0].force[0] = std::nan("");
  check("no number", std::isinf(certify(scene, forces).error()));
  // Mechanisms: one that closes a joint, one that rises against the load.
  SpaceMotion motion(2, *scene.blocks->kinematics);
  motion.displacement[0] = vector(1., 0., 0.);
  check("into the other block",
        certify_mechanism(scene, motion).closing_violation > 0.9);
  motion.displacement[0] = motion.displacement[1] = vector(0., 0., 1.);
  check("upwards",
        !proves_collapse(certify_mechanism(scene, motion)) &&
            certify_mechanism(scene, motion).closing_violation == 0.);
  motion.displacement[0] = motion.displacement[1] = vector(1., 0., 0.);
  check("sliding needs lifting",
        certify_mechanism(scene, motion).closing_violation > 0.49);
  motion.rotation[0] = vector(0., 0., 0.1);
  check("turning into the other",
        certify_mechanism(scene, motion).closing_violation > 0.);
}

/** States far from the limit and beside it, with all that joints bear. */
void verdicts()
{
  for (const double tension : {0., 0.05})
    for (const double crushing : {0., 3.})
      for (const bool turns : {false, true})
      {
        SpaceCase wall{Packing<3>(brick_wall(3, 1, 3))};
        wall.mu = 0.6;
        wall.strength = 0.1;
        wall.tension = tension;
        wall.crushing = crushing;
        wall.turns = turns;
        const SpaceLoads dead = body_force(wall.packing, vector(0., 0., -1.)),
                         live = body_force(wall.packing, vector(0.8, 0.6, 0.));
        const auto factor = proven_factor(
            text("wall", tension > 0. ? ", tension" : "",
                 crushing > 0. ? ", crushing" : "", turns ? ", turning" : ""),
            wall, dead, live, true, crushing > 0. ? 1e-6 : 1e-8);
        const auto blocks = wall.blocks();
        for (const double share : {0.5, 1. - 1e-6, 1. + 1e-6})
          std::cout << "  at " << (share < 1. ? "less" : "more") << ": "
                    << proven_verdict(SpaceScene(
                           blocks,
                           together(dead, share * factor.carried, live)))
                    << std::endl;
      }
}

void run()
{
  closed_forms();
  refusals();
  planted_errors();
  verdicts();
}

const RoomTest test("space_loads", run);
} // namespace test_space_loads
