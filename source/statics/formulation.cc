// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/equilibrate.h>
#include <voussoir/statics/find_opening.h>
#include <voussoir/statics/formulation.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/** The largest |a - b|, over the largest force of both; zero for no forces. */
double relative_change(const InterfaceForces &a, const InterfaceForces &b)
{
  double change = 0., largest = 0.;
  const auto compare = [&](const std::vector<double> &x,
                           const std::vector<double> &y) {
    for (unsigned int e = 0; e < x.size(); ++e)
    {
      change = std::max(change, std::abs(x[e] - y[e]));
      largest = std::max({largest, std::abs(x[e]), std::abs(y[e])});
    }
  };
  compare(a.normal, b.normal);
  compare(a.tangential, b.tangential);
  return largest > 0. ? change / largest : 0.;
}

InterfaceForces times(const double factor, InterfaceForces forces)
{
  for (double &f : forces.normal)
    f *= factor;
  for (double &f : forces.tangential)
    f *= factor;
  return forces;
}

/** The unit of a force per unit thickness. */
double force_scale(const DiscreteProblem &problem)
{
  return problem.stress_scale() * problem.length_scale();
}
} // namespace

Solution Formulation::solve(const DiscreteProblem &problem,
                            const SolverControls &controls,
                            Terminal &terminal) const
{
  if (!problem.joints().empty() && problem.is_loaded())
  {
    Solution solution = select(problem, controls, terminal);
    if (controls.equilibrate && !solution.mechanism)
      equilibrate_solution(problem, solution);
    return solution;
  }

  Solution nothing;
  nothing.forces.normal.resize(problem.joints().size());
  nothing.forces.tangential.resize(problem.joints().size());
  nothing.displacement.resize(problem.n_cells());
  nothing.stop = Stop::Reason::nothing_to_balance;
  return nothing;
}

void equilibrate_solution(const DiscreteProblem &problem, Solution &solution)
{
  InterfaceForces balanced = equilibrate(problem, solution.forces);
  solution.correction = relative_change(solution.forces, balanced);
  solution.forces = std::move(balanced);
}

void require_interior(const DiscreteProblem &problem,
                      const std::string &formulation)
{
  if (!opening_of(problem).displacement.empty())
    return;
  const std::string advice =
      "The formulation '" + formulation +
      "' has no answer there; set 'Formulation = least energy', which has one.";
  if (!opening_of(problem).self_stress.empty())
    throw InputError(
        "The supports clamp the packing: no motion opens all contacts, so that "
        "normal forces can balance by themselves and have no bound. " +
        advice);
  throw InputError(
      "Whether the supports clamp the packing cannot be told: a motion that "
      "opens all contacts would open some of them by no more than the rounding "
      "of the coordinates, or could not be found. " +
      advice);
}

InterfaceForces dimensional_forces(const DiscreteProblem &problem,
                                   const Solution &solution)
{
  return times(force_scale(problem), solution.forces);
}

InterfaceForces nondimensional_forces(const DiscreteProblem &problem,
                                      InterfaceForces forces)
{
  return times(1. / force_scale(problem), std::move(forces));
}
} // namespace Voussoir
