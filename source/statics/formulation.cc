// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters.h>
#include <voussoir/statics/analytic_centre.h>
#include <voussoir/statics/equilibrate.h>
#include <voussoir/statics/formulation.h>
#include <voussoir/statics/least_energy.h>
#include <voussoir/statics/linear_program.h>
#include <voussoir/statics/smoothed_friction.h>

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
  nothing.outcome = nothing_to_balance;
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
  if (!problem.opening().empty())
    return;
  const std::string advice =
      "The formulation '" + formulation +
      "' has no answer there; set 'Formulation = least energy', which has one.";
  if (!problem.self_stress().empty())
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

SolverParameters::SolverParameters(const Team &team)
{
  common.team = team;
  // The one place where a formulation is registered.
  formulations.push_back(std::make_unique<SmoothedFriction>());
  formulations.push_back(std::make_unique<LinearProgram>());
  formulations.push_back(std::make_unique<AnalyticCentre>());
  formulations.push_back(std::make_unique<LeastEnergy>());
}

void SolverParameters::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  std::vector<Choice<unsigned int>> choices;
  for (unsigned int i = 0; i < formulations.size(); ++i)
    choices.push_back({i, formulations[i]->name(), formulations[i]->meaning()});
  add_choice(prm, "Formulation", chosen, choices,
             "How one of the many admissible and balanced states is selected.");

  prm.enter_subsection("Solver");
  prm.add_parameter("Tolerance", common.tolerance,
                    "The largest force imbalance of a cell to stop at, as a "
                    "fraction of the sum of the sizes of all loads over the "
                    "square root of the number of cells. Hard contact stops at "
                    "a hundredth of its 'Barrier parameter', if that is less.",
                    Double(1e-14, 1e-2));
  prm.add_parameter("Maximum iterations", common.n_max_iterations,
                    "Give up after so many iterations. A search for a proof of "
                    "collapse that follows has as many of its own.",
                    Integer(1, 1000000));
  prm.add_parameter("Equilibrate", common.equilibrate,
                    "Whether the forces are then corrected, as little as "
                    "possible, until every cell balances to rounding. It costs "
                    "as much as a few iterations of Newton's method.",
                    Bool());
  for (const auto &formulation : formulations)
  {
    prm.enter_subsection(formulation->name());
    formulation->add_parameters(prm);
    prm.leave_subsection();
  }
  prm.leave_subsection();
}

const Formulation &SolverParameters::formulation() const
{
  return *formulations[chosen];
}

const SolverControls &SolverParameters::controls() const
{
  return common;
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
