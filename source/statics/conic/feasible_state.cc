// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/blended_loads.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/problem/coulomb_limits.h>
#include <voussoir/statics/problem/sufficient_strengths.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The residual of a state whose forces are that much larger than the loads, as
 * between supports that clamp it, and where a second search for smaller ones
 * starts, SelfDual::Program::first_slack.
 */
constexpr double residual_of_small_forces = 1e-12, smaller_first_slack = 1.;

/** The mechanism of a ray, along which the loads do work for nothing. */
std::vector<double> collapse_of(ConicForces &forces,
                                const SelfDual::Program &program,
                                SelfDual::Point ray)
{
  const double size = largest_component(ray.u);
  for (auto *const v : {&ray.u, &ray.z})
    for (double &component : *v)
      component /= size;
  return mechanism_near(forces, program, ray).u;
}

/** find_feasible_forces() from SelfDual::Program::first_slack. */
FeasibleForces find_from(const double first_slack,
                         RowProblem &problem,
                         const std::vector<double> &loads,
                         const unsigned int n_max_iterations,
                         Terminal &terminal)
{
  SelfDual::Program fixed = {loads};
  fixed.is_verdict = true;
  fixed.first_slack = first_slack;
  SelfDual program(problem.forces(), fixed);
  SelfDual::State state = SelfDual::State::running;
  FeasibleForces found;
  while (state == SelfDual::State::running && !found.state &&
         program.n_iterations() < n_max_iterations)
  {
    state = program.step();
    terminal.iteration("Interior point",
                       text("iteration ", program.n_iterations(), ", error ",
                            program.merit()));
    if (!(program.merit() < merit_worth_correcting))
      continue;
    FactorState near = state_near(problem.forces(), fixed, program.point());
    if (near.residual <= largest_residual_of_state)
      found.state = std::move(near);
  }
  if (state == SelfDual::State::infeasible)
    found.collapse = collapse_of(problem.forces(), fixed, program.point());
  found.n_iterations = program.n_iterations();
  return found;
}
} // namespace

FeasibleForces find_feasible_forces(RowProblem &problem,
                                    const std::vector<double> &loads,
                                    const unsigned int n_max_iterations,
                                    Terminal &terminal)
{
  FeasibleForces found = find_from(SelfDual::Program().first_slack, problem,
                                   loads, n_max_iterations, terminal);
  if (!found.state || found.state->residual <= residual_of_small_forces)
    return found;
  FeasibleForces smaller =
      find_from(smaller_first_slack, problem, loads,
                n_max_iterations - found.n_iterations, terminal);
  smaller.n_iterations += found.n_iterations;
  if (!smaller.state || !(smaller.state->residual < found.state->residual))
    smaller.state = std::move(found.state);
  smaller.collapse.clear();
  return smaller;
}

namespace
{
/** The distance of the two bounds of a share between which none decides. */
constexpr double distance_of_bounds = 1e-10;

/** In units of stress. */
constexpr double strong_limit = 1e4;
/** Over the largest force. */
constexpr double rounding_of_forces = 1e-13;

/** The solution of a problem that collapses in a displacement @p u of rows. */
Solution collapse_with(const RowProblem &problem, const std::vector<double> &u)
{
  Solution solution;
  solution.stop = Stop::Reason::collapse;
  const DiscreteProblem &of = problem.of();
  const double dissipation =
      of.is_plane()
          ? dissipation_of(of, u.data())
          : problem.rows().dissipation_of_jumps(problem.rows().jumps(u));
  solution.mechanism =
      Mechanism{problem.of_size_one(u), of.work(u.data()), dissipation};
  return solution;
}

/** find_state_or_collapse() with the strengths as they are. */
Solution find_at_once(const DiscreteProblem &problem,
                      const unsigned int n_max_iterations,
                      Terminal &terminal)
{
  RowProblem by_rows(problem);
  const FeasibleForces found = find_feasible_forces(by_rows, by_rows.loads(),
                                                    n_max_iterations, terminal);
  Solution solution;
  if (!found.collapse.empty())
    solution = collapse_with(by_rows, found.collapse);
  else if (found.state)
  {
    solution.stop = Stop::Reason::converged;
    solution.forces = by_rows.rows().forces_of(found.state->x);
  }
  solution.n_iterations = solution.n_evaluations = found.n_iterations;
  return solution;
}

/** Whether forces of a problem with larger limits are within those of @p
 * problem, but for rounding. */
bool is_within_limits(const DiscreteProblem &problem,
                      const std::vector<double> &forces)
{
  if (!(excess_of_friction(problem, forces) <=
        rounding_of_forces * largest_component(forces)))
    return false;
  for (unsigned int e = 0; e < problem.normal_limits().size(); ++e)
  {
    const double crushing = problem.normal_limits()[e].crushing;
    const unsigned int n = problem.n_contacts(e);
    if (!std::isfinite(crushing) || n == 0)
      continue;
    const double *const of = &forces[problem.first_row(e)];
    const double tension = problem.tension(e);
    // Of a section without ends each has a half.
    const double start = 0.5 * tension - (n == 1 ? 0.5 : 1.) * of[0],
                 end = n == 1 ? start : 0.5 * tension - of[n - 1];
    const double pressure = start + end;
    if (pressure * pressure > 2. * (tension + crushing) * std::min(start, end))
      return false;
  }
  return true;
}

/**
 * find_at_once() without the limits of friction and crushing that are far
 * beyond the loads: forces have no scale then, as those of dry joints, and
 * joints that only these limits let move do not. Nothing is found if these
 * forces, or this motion, are none of the problem.
 */
Solution find_without_strong_limits(const DiscreteProblem &problem,
                                    const unsigned int n_max_iterations,
                                    Terminal &terminal)
{
  if (!problem.is_plane())
    return {};
  const std::optional<DiscreteProblem> unlimited =
      problem.without_strengths_above(strong_limit);
  if (!unlimited)
    return {};
  Solution found = find_at_once(*unlimited, n_max_iterations, terminal);
  if (found.converged() ? is_within_limits(problem, found.forces)
                        : collapses_with(problem, found))
    return found;
  Solution none;
  none.n_iterations = none.n_evaluations = found.n_iterations;
  return none;
}

/** Whether the greatest share of loads that are blended is above one, or below.
 */
Solution decide_by_share(const DiscreteProblem &problem,
                         const unsigned int n_max_iterations,
                         Terminal &terminal)
{
  BlendedLoads blend(problem);
  SelfDual::Program of_share = blend.program();
  of_share.is_verdict = true;
  ProvenFactor share(blend.by_rows().forces(), of_share,
                     {distance_of_bounds, 1., n_max_iterations}, terminal);
  const auto is_carried = [&] {
    return share.carried() && share.carried()->alpha >= 1.;
  };
  const auto collapses = [&] {
    return share.mechanism() &&
           blend.collapse(*share.mechanism(), share.bound());
  };
  share.find([&] { return is_carried() || collapses(); });
  Solution solution;
  if (is_carried())
  {
    solution.stop = Stop::Reason::converged;
    solution.forces =
        blend.forces_of_all(share.carried()->x, share.carried()->alpha);
  }
  else if (collapses())
    solution = collapse_with(blend.by_rows(), share.mechanism()->u);
  solution.n_iterations = solution.n_evaluations = share.n_iterations();
  return solution;
}

bool has_answer(const Solution &found)
{
  return found.converged() || found.mechanism;
}

/** Take what was found next, with the iterations of both. */
void add_attempt(Solution &found, Solution next)
{
  next.n_iterations += found.n_iterations;
  next.n_evaluations += found.n_evaluations;
  found = std::move(next);
}
} // namespace

Solution find_state_or_collapse(const DiscreteProblem &problem,
                                const unsigned int n_max_iterations,
                                Terminal &terminal)
{
  SolverControls controls;
  controls.n_max_iterations = n_max_iterations;
  Solution found = solve_with_sufficient_strengths(
      problem, controls,
      [&](const DiscreteProblem &lowered, const SolverControls &rest) {
        return find_at_once(lowered, rest.n_max_iterations, terminal);
      });
  for (const auto &try_next : {find_without_strong_limits, decide_by_share})
    if (!has_answer(found))
      add_attempt(found, try_next(problem, n_max_iterations, terminal));
  return found;
}

std::optional<Mechanism> find_collapse(const DiscreteProblem &problem,
                                       Terminal &terminal)
{
  const unsigned int n_max_iterations = SolverControls().n_max_iterations;
  Solution found = decide_by_share(problem, n_max_iterations, terminal);
  if (!has_answer(found))
    found = find_without_strong_limits(problem, n_max_iterations, terminal);
  return found.mechanism;
}

Solution FeasibleState::select(const DiscreteProblem &problem,
                               const SolverControls &controls,
                               Terminal &terminal) const
{
  Solution found =
      find_state_or_collapse(problem, controls.n_max_iterations, terminal);
  if (!has_answer(found))
    throw SolverError(
        text("Neither forces that carry the loads nor a mechanism were found "
             "after ",
             counted(found.n_iterations, "iteration"),
             ". The load is close to what the packing can carry, or "
             "'Solver/Maximum iterations' is small."));
  return found;
}
} // namespace Voussoir
