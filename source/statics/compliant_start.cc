// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/compliant_start.h>
#include <voussoir/statics/minimise.h>

#include <algorithm>
#include <optional>

namespace Voussoir
{
namespace
{
/**
 * The imbalance to stop at, over the tolerance: the forces are then those of
 * the minimum to all the digits that are asked for.
 */
constexpr double imbalance_over_tolerance = 1e-2;
/** The residual of the linear systems, as good as a step of Newton's is. */
constexpr double residual_of_systems = 1e-2;
/** Close to the limit of the load more are needed than Ipopt would. */
constexpr unsigned int n_steps = 15;
} // namespace

CompliantStart compliant_start(const DiscreteProblem &problem,
                               const SmoothedJoint &law,
                               const SolverControls &controls,
                               Terminal &terminal)
{
  CompliantStart start;
  start.displacement.assign(problem.n_dofs(), 0.);
  JointSystem system(problem, LinearSolver::automatic, residual_of_systems);
  Newton newton(problem, law, system, start.displacement);
  const auto advance = [&newton]() {
    newton.step(least_shift, newton.u());
    return std::optional<Mechanism>();
  };
  try
  {
    const NewtonControls of_newton = {
        imbalance_over_tolerance * controls.tolerance,
        std::min(n_steps, controls.n_max_iterations)};
    if (minimise(SharedProblem(problem), newton, of_newton, advance, 0.,
                 terminal)
            .converged())
      start = {newton.u(), newton.n_iterations(), newton.n_evaluations()};
  }
  catch (const SolverError &)
  {
    // Ipopt has other means.
  }
  return start;
}
} // namespace Voussoir
