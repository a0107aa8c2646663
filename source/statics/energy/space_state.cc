// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/energy/elastic_faces.h>
#include <voussoir/statics/energy/energy_program.h>
#include <voussoir/statics/energy/space_state.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The steps of Newton's method before an EnergyProgram is asked, and those
 * behind it. Far from the limit it takes one to six.
 */
constexpr unsigned int n_steps_before_doubt = 8, n_steps_behind = 12;
/**
 * The imbalance, over the tolerance, with which there is no doubt that loads
 * are carried: just beyond the limit nothing balances them to rounding.
 */
constexpr double beyond_doubt = 1e-2;
/** The error of the program that is enough to go on from, or without. */
constexpr double error_of_start = 1e-8, error_of_end = 1e-14,
                 accepted_error = 1e-11;

/** The search for one state. */
class SpaceStateSearch
{
public:
  SpaceStateSearch(const DiscreteProblem &problem,
                   const SolverControls &controls,
                   const LinearSolver linear_solver,
                   Terminal &terminal)
      : problem(problem), controls(controls), linear_solver(linear_solver),
        terminal(terminal)
  {}

  Solution find();

private:
  bool crushes() const
  {
    return std::any_of(problem.normal_limits().begin(),
                       problem.normal_limits().end(),
                       [](const NormalLimits &limits) {
                         return std::isfinite(limits.crushing);
                       });
  }
  bool minimise_by_newton(const std::vector<double> &start,
                          unsigned int n_most);
  EnergyProgram minimise_by_program(double error);
  void take(EnergyProgram program);

  const DiscreteProblem &problem;
  const SolverControls &controls;
  const LinearSolver linear_solver;
  Terminal &terminal;
  Solution found;
  /** A state that balances the loads within the tolerance. */
  std::optional<Solution> in_doubt;
};

/** @return true if it has converged without a doubt. */
bool SpaceStateSearch::minimise_by_newton(const std::vector<double> &start,
                                          const unsigned int n_most)
{
  FaceMinimum minimum =
      minimise_faces(problem, {linear_solver, controls.tolerance, n_most},
                     start, controls.processes, terminal);
  Solution &here = minimum.solution;
  here.n_iterations += found.n_iterations;
  here.n_evaluations += found.n_evaluations;
  here.seconds["linear systems"] += found.seconds["linear systems"];
  found = std::move(here);
  if (!(minimum.imbalance <= controls.tolerance))
    return false;
  found.stop = Stop::Reason::converged;
  if (minimum.imbalance <= beyond_doubt * controls.tolerance)
    return true;
  in_doubt = found;
  found.stop = Stop::Reason::not_stopped;
  return false;
}

EnergyProgram SpaceStateSearch::minimise_by_program(const double error)
{
  EnergyProgram program =
      solve_energy_program(problem, elastic_costs(problem), error,
                           controls.n_max_iterations, terminal);
  found.n_iterations += program.n_iterations;
  found.n_evaluations += program.n_iterations;
  return program;
}

void SpaceStateSearch::take(EnergyProgram program)
{
  if (program.mechanism)
  {
    found.stop = Stop::Reason::collapse;
    found.mechanism = std::move(program.mechanism);
  }
  else if (program.error <= accepted_error)
  {
    found.stop = Stop::Reason::converged;
    found.forces = std::move(program.forces);
    found.u = std::move(program.u);
    problem.remove_rigid_motions(found.u);
  }
}

Solution SpaceStateSearch::find()
{
  const bool by_newton = !crushes();
  const bool has_start =
      controls.start && controls.start->u.size() == problem.n_dofs();
  if (by_newton &&
      minimise_by_newton(has_start ? controls.start->u
                                   : std::vector<double>(problem.n_dofs(), 0.),
                         n_steps_before_doubt))
    return std::move(found);
  EnergyProgram program =
      minimise_by_program(by_newton ? error_of_start : error_of_end);
  if (by_newton && !program.mechanism && !program.u.empty())
  {
    if (minimise_by_newton(program.u, n_steps_behind))
      return std::move(found);
    if (program.error > accepted_error)
      program = minimise_by_program(error_of_end);
  }
  take(std::move(program));
  if (found.converged() || found.mechanism)
    return std::move(found);
  if (in_doubt)
    return std::move(*in_doubt);
  Solution any = FeasibleState().solve(problem, controls, terminal);
  any.n_iterations += found.n_iterations;
  any.n_evaluations += found.n_evaluations;
  if (any.converged())
    any.selection = FeasibleState().selection();
  return any;
}
} // namespace

Solution find_space_state(const DiscreteProblem &problem,
                          const SolverControls &controls,
                          const LinearSolver linear_solver,
                          Terminal &terminal)
{
  if (problem.joints().empty() || !problem.is_loaded())
  {
    Solution nothing;
    nothing.forces.resize(problem.n_all_rows());
    nothing.stop = Stop::Reason::nothing_to_balance;
    return nothing;
  }
  return SpaceStateSearch(problem, controls, linear_solver, terminal).find();
}
} // namespace Voussoir
