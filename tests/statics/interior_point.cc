// SPDX-License-Identifier: LGPL-2.1-or-later

// The interior point finds the states of the other methods, where these find
// them as well, and load factors that are known in closed form; its forces are
// admissible and balanced to rounding. Friction follows its law.

#include <voussoir/statics/conic/second_attempts.h>

#include "tests.h"

namespace test_interior_point
{
using namespace Voussoir;

/** What each joint costs in the formulation @p method. */
std::vector<JointCost> costs_of(const DiscreteProblem &problem,
                                const Method &method)
{
  std::vector<JointCost> costs;
  for (const auto &joint : problem.joints())
  {
    const double compliance = joint.distance / joint.length;
    if (method.name == least_energy.name)
      costs.push_back({compliance, compliance, 0.});
    else
      costs.push_back({compliance, 0., compliance * joint.strength});
  }
  return costs;
}

void compare(const std::string &name, const Scene &scene)
{
  for (const Method &method : {compliant, least_energy})
  {
    const DiscreteProblem problem = discretise(scene);
    Solver solver(method, 1e-12);
    const Solution known = solver.solve(problem);
    const Solution found = minimise_by_interior_point(
        problem, costs_of(problem, method), {1e-12, 200}, {}, solver.quiet);
    std::cout << name << ", " << method.name << std::endl;
    check("  known: " + known.stop.words(), known.converged());
    check("  found", found.converged());
    if (!known.converged() || !found.converged())
      continue;
    double apart = 0.;
    for (unsigned int k = 0; k < known.forces.size(); ++k)
      apart = std::max(apart, std::abs(found.forces[k] - known.forces[k]));
    check_error("  forces", apart, 1e-7);
    const Certificate certificate =
        certify(scene, dimensional_forces(problem, found));
    check_error("  equilibrium", certificate.equilibrium_residual, 1e-13);
    check("  admissible", certificate.admissibility_violation == 0.);
    double difference = 0., size = 0.;
    for (std::size_t k = 0; k < known.u.size(); ++k)
    {
      size = std::max(size, std::abs(known.u[k]));
      difference = std::max(difference, std::abs(known.u[k] - found.u[k]));
    }
    check_error("  displacements", difference / size, 1e-5);
  }
}

void find_factor(const std::string &name,
                 const Scene &scene,
                 const double exact)
{
  const DiscreteProblem problem = discretise(scene);
  InteriorPoint point(problem, std::vector<JointCost>(problem.joints().size()),
                      InteriorPoint::Aim::load_factor);
  while (point.product() > 1e-11 && point.n_iterations() < 60 && point.step())
    ;
  check_error(name + ": load factor",
              std::abs(point.load_factor() / exact - 1.), 1e-8);
  std::ostringstream nowhere;
  Terminal quiet(nowhere, 0);
  const auto mechanism = find_collapse_by_load_factor(problem, quiet);
  check(name + ": mechanism if and only if that is below one",
        mechanism.has_value() == (exact < 1.));
  if (mechanism)
    check("  which proves it",
          proves_collapse(certify_mechanism(
              scene, dimensional_motion(discretise(scene), *mechanism))));
}

/** Steps to smaller and smaller products end at q = b v / sqrt(v^2 + eps^2). */
void follow(const double strength, const double smoothing)
{
  FrictionCone cone(strength, smoothing, strength);
  const double force = 0.6 * strength;
  double target = strength;
  for (unsigned int k = 0; k < 32; ++k)
  {
    target *= 0.5;
    cone.linearise();
    const FrictionCone::Step step = cone.step(target, force - cone.force());
    const double part = std::min({1., 0.9 * cone.longest_of_force(step),
                                  0.9 * cone.longest_of_sliding(step)});
    cone.take(step, part, part);
  }
  check_error("friction: product", std::abs(cone.product() / target - 1.),
              1e-6);
  check_error("friction: force", std::abs(cone.force() - force), 1e-12);
  check_error("friction: sliding", std::abs(cone.sliding() - smoothing * 0.75),
              1e-9);
}

void run()
{
  compare("random cells", scene_under_stress(random_packing(300, 1), 0.35,
                                             tensor(-0.3, 0., 0., -1.7)));
  compare("random cells, hardly any sliding",
          scene_under_stress(random_packing(200, 2), 1.,
                             tensor(-1., 0.3, 0.3, -1.)));
  for (const double strength : {1.5, 1. + 1e-6, 1. - 1e-6, 0.2})
    find_factor("shear wall", shear_wall(strength), strength);
  for (const double d : {0.2, 0.3 * (1. - 1e-6), 0.3 * (1. + 1e-6), 0.5})
    find_factor("turned squares",
                scene_under_stress(turned_squares(12), 0.3,
                                   tensor(-1 + d, 0, 0, -1 - d)),
                0.3 / d);
  follow(2., 0.);
  follow(2., 0.5);
  follow(1e-4, 1e-3);
}

const RoomTest test("interior_point", run);
} // namespace test_interior_point
