// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/problem/equilibrate.h>
#include <voussoir/statics/problem/find_opening.h>
#include <voussoir/statics/problem/formulation.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/** The largest |a - b|, over the largest force of both; zero for no forces. */
double relative_change(const std::vector<double> &a,
                       const std::vector<double> &b)
{
  double change = 0., largest = 0.;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    change = std::max(change, std::abs(a[k] - b[k]));
    largest = std::max({largest, std::abs(a[k]), std::abs(b[k])});
  }
  return largest > 0. ? change / largest : 0.;
}
} // namespace

Solution Formulation::solve(const DiscreteProblem &problem,
                            const SolverControls &controls,
                            Terminal &terminal) const
{
  if (!problem.joints().empty() && problem.is_loaded())
  {
    Solution solution;
    try
    {
      solution = select(problem, controls, terminal);
    }
    catch (const NewtonFailure &failure)
    {
      const bool too_stiff = failure.cause == NewtonFailure::Cause::stiffness;
      throw SolverError(failure.what() +
                        std::string(too_stiff
                                        ? " Lower 'Friction/Strength', or"
                                          " take another 'Formulation'."
                                        : " Take another 'Formulation'."));
    }
    if (controls.equilibrate && !solution.mechanism)
      equilibrate_solution(problem, solution);
    if (solution.displacement_unit == 0.)
      solution.displacement_unit = displacement_unit(problem);
    return solution;
  }

  Solution nothing;
  nothing.forces.resize(problem.n_all_rows());
  nothing.stop = Stop::Reason::nothing_to_balance;
  return nothing;
}

void equilibrate_solution(const DiscreteProblem &problem, Solution &solution)
{
  std::vector<double> balanced = equilibrate(problem, solution.forces);
  solution.correction = relative_change(solution.forces, balanced);
  solution.forces = std::move(balanced);
}

void require_interior(const DiscreteProblem &problem,
                      const std::string &formulation)
{
  if (!opening_of(problem).displacement.empty())
    return;
  throw InputError(
      reason_of_no_opening(opening_of(problem), problem.has_ground()) +
      " The formulation '" + formulation +
      "' has no answer there; set 'Formulation = least energy', "
      "which has one.");
}
} // namespace Voussoir
