// SPDX-License-Identifier: LGPL-2.1-or-later

// A second kinematics and a second law of friction need no more than a class
// each. Here are two whose answers are known: bodies with a third unknown that
// nothing moves, which has the forces of translations, and a friction of twice
// the strength, which has those of twice the strength.

#include <voussoir/scene/proofs/utilisation.h>

#include "tests.h"

namespace test_other_laws
{
using namespace Voussoir;

/** Translations, and a third unknown that is idle. */
class Idle : public Kinematics
{
public:
  std::string name() const override { return "idle"; }
  unsigned int n_unknowns() const override { return 3; }
  unsigned int n_contacts() const override
  {
    return translations().n_contacts();
  }
  void find_rows(const JointFrame &joint, ContactRow *rows) const override
  {
    translations().find_rows(joint, rows);
  }
  unsigned int n_rigid_motions() const override
  {
    return translations().n_rigid_motions();
  }
  void find_rigid_motion(const unsigned int k,
                         const dealii::Tensor<1, 2> &x,
                         double *unknowns) const override
  {
    translations().find_rigid_motion(k, x, unknowns);
    unknowns[2] = 0.;
  }
};

/** The friction of Tresca with twice the strength. */
class Twice : public FrictionLaw
{
public:
  std::string name() const override { return "twice"; }
  double limit(const double strength, const double /*normal*/) const override
  {
    return 2. * strength;
  }
};

void compare(const std::string &what,
             const Method &method,
             const Scene &known,
             const Scene &scene)
{
  const std::string name = what + ", " + method.name;
  const DiscreteProblem problem(known), other(scene);
  const Solution expected = Solver(method).solve(problem);
  const Solution found = Solver(method).solve(other);
  check(name + ": the same verdict",
        found.mechanism.has_value() == expected.mechanism.has_value() &&
            found.converged() == expected.converged());
  if (expected.mechanism)
    check("  which proves it",
          proves_collapse(certify_mechanism(known, found.mechanism->motion)));
  else if (method.name == linear_program.name) // whose forces are any
    check_error("  admissible and balanced",
                certify(known, dimensional_forces(other, found)).error(), 1e-8);
  else
    check_error("  the same forces",
                distance(dimensional_forces(other, found),
                         dimensional_forces(problem, expected)),
                1e-8);
}

/** The utilisation of the first joint of the analytic centre. */
double used_of_first(const Scene &scene, const Method &method)
{
  const InterfaceForces forces = Solver(method).forces(scene);
  return Utilisation(scene, forces)(0);
}

void run()
{
  const Idle idle;
  const Twice twice;
  // Carried with a part of the joints sliding, and not carried.
  for (const double strength : {0.35, 0.1})
  {
    const std::string name = strength > 0.2 ? "carried" : "not carried";
    const Scene known = scene_under_stress(random_packing(100, 1), strength,
                                           tensor(-1.3, 0.1, 0.1, -0.7));
    Scene scene = known;
    scene.kinematics = &idle;
    for (const Method &method : all_methods)
      compare("idle, " + name, method, known, scene);

    Scene half = scene_under_stress(random_packing(100, 1), 0.5 * strength,
                                    tensor(-1.3, 0.1, 0.1, -0.7));
    half.friction = &twice;
    for (const Method &method : all_methods)
      compare("twice, " + name, method, known, half);
    if (strength > 0.2)
      check("what it uses of its strength",
            std::abs(used_of_first(half, centre) -
                     used_of_first(known, centre)) < 1e-8);
  }
}

const RoomTest test("other_laws", run);
} // namespace test_other_laws
