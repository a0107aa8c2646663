// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/statics/energy/minimise.h>
#include <voussoir/statics/problem/solver_controls.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** The steps after which there is doubt, unless Newton's method converges. */
constexpr unsigned int n_before_doubt = 8;
/** After so many steps the method does not come back from such an imbalance,
 * over the first one. */
constexpr unsigned int n_astray = 3;
constexpr double imbalance_astray = 0.5;
} // namespace

bool is_in_doubt(const Newton &newton, const double first_imbalance)
{
  const unsigned int n = newton.n_iterations();
  if (n < n_astray || n > n_before_doubt)
    return false;
  return newton.imbalance() >
         (n == n_before_doubt ? imbalance_without_doubt
                              : std::max(imbalance_astray * first_imbalance,
                                         imbalance_without_doubt));
}

Solution minimise(const SharedProblem &problem,
                  Newton &newton,
                  const NewtonControls &controls,
                  const std::function<std::optional<Mechanism>()> &advance,
                  Terminal &terminal)
{
  Solution solution;
  std::vector<double> best_u;
  std::vector<double> best_forces;
  double least = std::numeric_limits<double>::infinity();
  unsigned int best = 0;
  bool has_best = false; // an imbalance may be no number

  while (solution.stop == Stop::Reason::not_stopped)
  {
    const double imbalance = newton.imbalance();
    const unsigned int n = newton.n_iterations();
    const bool converged = imbalance <= controls.imbalance &&
                           newton.decrement() <= controls.decrement &&
                           newton.force_change() <= controls.force_change;
    if (imbalance < least || converged || !has_best)
    {
      least = imbalance;
      best = n;
      has_best = true;
      best_u = newton.u();
      best_forces = newton.forces();
    }

    if (converged)
      solution.stop = Stop::Reason::converged;
    else if ((solution.mechanism = problem.search(newton.u(), find_mechanism)))
      solution.stop = Stop::Reason::collapse;
    else if (n >= controls.n_max_iterations)
      solution.stop = Stop::Reason::most_iterations;
    else if (least <= imbalance_near_rounding &&
             n > best + n_stalled_iterations)
      solution.stop = Stop::Reason::rounding;
    else
    {
      terminal.iteration("Newton",
                         text("iteration ", n, ", imbalance ", imbalance));
      if ((solution.mechanism = advance()))
        solution.stop = Stop::Reason::collapse;
    }
  }

  // Beyond the limit the displacement grows along a mechanism. One that turns
  // about hinges shows late, perhaps not before the last iteration.
  const bool blocks_turn = problem.structure().kinematics().turns();
  if ((solution.stop == Stop::Reason::rounding ||
       (blocks_turn && solution.stop == Stop::Reason::most_iterations)) &&
      (solution.mechanism = problem.search(newton.u(), find_mechanism_near)))
    solution.stop = Stop::Reason::collapse;

  solution.n_iterations = newton.n_iterations();
  solution.n_evaluations = newton.n_evaluations();
  solution.seconds["linear systems"] = newton.seconds_of_systems();
  problem.collect(best_u, best_forces, solution);
  return solution;
}
} // namespace Voussoir
