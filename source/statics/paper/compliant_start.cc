// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/energy/minimise.h>
#include <voussoir/statics/paper/compliant_start.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
/** The residual of the linear systems, as good as a step of Newton's is. */
constexpr double residual_of_systems = 1e-2;
/** At most; where the method is in doubt it takes no more. */
constexpr unsigned int n_steps = 30;
/** The error of the energy program that Newton's method starts from. */
constexpr double error_to_start_newton = 1e-8;
/** The error with which it is a start for Ipopt. */
constexpr double largest_error_of_start = 1e-4;

/**
 * Take Newton's steps from a displacement, and keep it if they converge.
 *
 * @return true if they do, or find a mechanism.
 */
bool converge(const DiscreteProblem &problem,
              const SmoothedJoint &law,
              JointSystem &system,
              const SolverControls &controls,
              Terminal &terminal,
              CompliantStart &start)
{
  Newton newton(problem, law, system, start.displacement);
  const double first_imbalance = newton.imbalance();
  NewtonControls of_newton = {controls.tolerance,
                              std::min(n_steps, controls.n_max_iterations)};
  const auto advance = [&]() {
    if (is_in_doubt(newton, first_imbalance))
      of_newton.n_max_iterations = newton.n_iterations();
    else
      newton.step(least_shift, newton.u());
    return std::optional<Mechanism>();
  };
  Solution solution =
      minimise(SharedProblem(problem), newton, of_newton, advance, terminal);
  const bool converged = solution.converged();
  start.mechanism = std::move(solution.mechanism);
  if (converged)
  {
    // One more step: the forces are then those of the minimum to more digits
    // than their balance asks for.
    start.displacement = newton.u();
    newton.full_step();
    if (newton.imbalance() <= controls.tolerance)
      start.displacement = newton.u();
  }
  if (converged || start.mechanism)
  {
    start.n_iterations += newton.n_iterations();
    start.n_evaluations += newton.n_evaluations();
  }
  return converged || start.mechanism;
}
} // namespace

std::vector<JointCost> smoothed_costs(const DiscreteProblem &problem,
                                      const SmoothedJoint &law)
{
  std::vector<JointCost> costs;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    costs.push_back(
        {1. / problem.joints()[e].stiffness(), 0., law.smoothing(e)});
  return costs;
}

CompliantStart compliant_start(const DiscreteProblem &problem,
                               const SmoothedJoint &law,
                               const SolverControls &controls,
                               Terminal &terminal)
{
  CompliantStart start;
  start.displacement.assign(problem.n_dofs(), 0.);
  JointSystem system(problem, LinearSolver::automatic, residual_of_systems);
  try
  {
    if (converge(problem, law, system, controls, terminal, start))
      return start;
    EnergyProgram program = solve_energy_program(
        problem, smoothed_costs(problem, law), error_to_start_newton,
        controls.n_max_iterations, terminal);
    start.mechanism = std::move(program.mechanism);
    if (start.mechanism || program.error <= largest_error_of_start)
      start.n_iterations += program.n_iterations;
    if (start.mechanism || !(program.error <= largest_error_of_start))
      return start;
    start.displacement = std::move(program.u);
    converge(problem, law, system, controls, terminal, start);
  }
  catch (const SolverError &)
  {
    // Ipopt has other means.
  }
  return start;
}
} // namespace Voussoir
