// SPDX-License-Identifier: LGPL-2.1-or-later

// The conic interior point finds the states of the other formulations, where
// these find them as well, and proves collapses beside load factors that are
// known in closed form. What it does with second-order cones keeps their
// identities.

#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/conic/quadratic_cone.h>
#include <voussoir/statics/energy/energy_program.h>

#include "tests.h"
#include <random>

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
    EnergyProgram found = solve_energy_program(
        problem, costs_of(problem, method), 1e-13, 100, solver.quiet);
    problem.remove_rigid_motions(found.u);
    std::cout << name << ", " << method.name << std::endl;
    check("  known: " + known.stop.words(), known.converged());
    check_error("  found", found.error, 1e-11);
    double apart = 0.;
    for (unsigned int k = 0; k < known.forces.size(); ++k)
      apart = std::max(apart, std::abs(found.forces[k] - known.forces[k]));
    // The error of forces is the root of that of their energy.
    check_error("  forces", apart, 3e-6);
    Solution solution;
    solution.forces = found.forces;
    const Certificate certificate =
        certify(scene, dimensional_forces(problem, solution));
    check_error("  equilibrium", certificate.equilibrium_residual, 1e-11);
    check_error("  admissible", certificate.admissibility_violation, 1e-11);
    double difference = 0., size = 0.;
    for (std::size_t k = 0; k < known.u.size(); ++k)
    {
      size = std::max(size, std::abs(known.u[k]));
      difference = std::max(difference, std::abs(known.u[k] - found.u[k]));
    }
    check_error("  displacements", difference / size, 1e-5);
  }
}

void find_collapses(const std::string &name,
                    const Scene &scene,
                    const double exact)
{
  const DiscreteProblem problem = discretise(scene);
  const auto check_proof = [&](const std::optional<Mechanism> &mechanism) {
    check(name + ": mechanism if and only if the factor is below one",
          mechanism.has_value() == (exact < 1.));
    if (mechanism)
      check("  which proves it",
            proves_collapse(certify_mechanism(
                scene, dimensional_motion(problem, *mechanism))));
  };
  check_proof(find_collapse(problem, Terminal::silent()));
  for (const Method &method : {compliant, least_energy})
    check_proof(solve_energy_program(problem, costs_of(problem, method), 1e-8,
                                     100, Terminal::silent())
                    .mechanism);
}

double distance(const QuadraticCone::Vector &v, const QuadraticCone::Vector &w)
{
  return std::abs(v[0] - w[0]) + std::hypot(v[1] - w[1], v[2] - w[2]);
}

/** The identities of the scaling, and of the product. */
void check_cones()
{
  using namespace QuadraticCone;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1., 1.);
  double of_scaling = 0., of_inverses = 0., of_quotient = 0., of_step = 0.;
  for (unsigned int k = 0; k < 1000; ++k)
  {
    const auto vector = [&](const double inside) {
      Vector v = {{0., number(random), number(random)}};
      v[0] = std::hypot(v[1], v[2]) + inside;
      return v;
    };
    // Some close to the boundary.
    const double near = std::pow(10., -4. * std::abs(number(random)));
    const Vector s = vector(near), z = vector(1.), d = vector(-0.9);
    const Scaling W = Scaling::of(s, z);
    const double size = std::abs(W.times(z)[0]);
    of_scaling =
        std::max(of_scaling, distance(W.times(z), W.over(s)) / size * near);
    of_inverses = std::max(of_inverses, near * distance(W.times(W.over(d)), d));
    of_inverses =
        std::max(of_inverses,
                 near * near * distance(W.times_square(W.over_square(d)), d));
    of_inverses = std::max(
        of_inverses,
        near * distance(W.over(W.over(d)), W.over_square(d)) * W.eta_squared);
    of_quotient =
        std::max(of_quotient, near * distance(product(s, quotient(s, d)), d));
    const double inverse = inverse_of_longest(s, d);
    if (inverse > 0.)
    {
      Vector end = s;
      for (unsigned int i = 0; i < 3; ++i)
        end[i] += d[i] / inverse;
      of_step =
          std::max(of_step, std::abs(end[0] - std::hypot(end[1], end[2])) /
                                (1. + 1. / inverse));
    }
    const auto values = eigenvalues(d);
    of_quotient =
        std::max(of_quotient, distance(with_eigenvalues(d, values), d));
  }
  check_error("cones: W z = W^-1 s", of_scaling, 1e-12);
  check_error("cones: inverses", of_inverses, 1e-12);
  check_error("cones: quotients and eigenvalues", of_quotient, 1e-12);
  check_error("cones: steps end at the boundary", of_step, 1e-12);
}

void run()
{
  compare("random cells", scene_under_stress(random_packing(300, 1), 0.35,
                                             tensor(-0.3, 0., 0., -1.7)));
  compare("random cells, hardly any sliding",
          scene_under_stress(random_packing(200, 2), 1.,
                             tensor(-1., 0.3, 0.3, -1.)));
  for (const double strength : {1.5, 1. + 1e-6, 1. - 1e-6, 0.2})
    find_collapses("shear wall", shear_wall(strength), strength);
  for (const double d : {0.2, 0.3 * (1. - 1e-6), 0.3 * (1. + 1e-6), 0.5})
    find_collapses("turned squares",
                   scene_under_stress(turned_squares(12), 0.3,
                                      tensor(-1 + d, 0, 0, -1 - d)),
                   0.3 / d);
  check_cones();
}

const RoomTest test("interior_point", run);
} // namespace test_interior_point
