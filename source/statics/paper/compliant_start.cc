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
        controls.tolerance, std::min(n_steps, controls.n_max_iterations)};
    if (minimise(SharedProblem(problem), newton, of_newton, advance, terminal)
            .converged())
    {
      // One more step: the forces are then those of the minimum to more digits
      // than their balance asks for.
      std::vector<double> balanced = newton.u();
      newton.full_step();
      start = {newton.imbalance() <= controls.tolerance ? newton.u()
                                                        : std::move(balanced),
               newton.n_iterations(), newton.n_evaluations()};
    }
  }
  catch (const SolverError &)
  {
    // Ipopt has other means.
  }
  return start;
}
} // namespace Voussoir
