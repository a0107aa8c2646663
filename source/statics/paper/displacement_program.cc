// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/paper/displacement_program.h>

#include <algorithm>
#include <utility>

namespace Voussoir
{
namespace
{
/** The strength s_e, nondimensional, that hardly holds a body. */
constexpr double hardly_any_strength = 1e-4;

/** The iterations after which the load may be one that is not carried. */
constexpr unsigned int n_before_doubt = 25;

/** The unknowns of the bodies that are held, one in each connected group. */
std::vector<unsigned int> held_unknowns(const DiscreteProblem &problem)
{
  std::vector<unsigned int> held;
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
    if (problem.is_held(b))
      for (unsigned int i = 0; i < problem.n_unknowns(); ++i)
        held.push_back(problem.dof(b, i));
  return held;
}

/** The unknowns of the bodies that hardly any friction holds. */
std::vector<unsigned int> loose_unknowns(const DiscreteProblem &problem)
{
  std::vector<bool> is_loose(problem.n_bodies(), true);
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const DiscreteProblem::Joint &joint = problem.joints()[e];
    if (problem.limit(e) > hardly_any_strength * joint.length)
      is_loose[joint.cell_minus] = is_loose[joint.cell_plus] = false;
  }
  std::vector<unsigned int> loose;
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
    if (is_loose[b])
      for (unsigned int i = 0; i < problem.n_unknowns(); ++i)
        loose.push_back(problem.dof(b, i));
  return loose;
}

/**
 * Move each connected group so that the body that is held starts at zero: close
 * to the end displacements may be many orders smaller than those of the start,
 * and their differences would lose digits to a common translation.
 */
void hold_bodies(const DiscreteProblem &problem, std::vector<double> &start)
{
  std::vector<double> u(start.begin(), start.begin() + problem.n_dofs());
  problem.hold_bodies(u);
  std::copy(u.begin(), u.end(), start.begin());
}

Stop stop_of(const IpoptResult &result)
{
  switch (result.outcome)
  {
  case IpoptOutcome::converged: return Stop::Reason::converged;
  case IpoptOutcome::looser_tolerance: return Stop::Reason::looser_tolerance;
  case IpoptOutcome::rounding: return Stop::Reason::rounding;
  case IpoptOutcome::most_iterations: return Stop::Reason::most_iterations;
  case IpoptOutcome::diverged: return Stop::Reason::diverged;
  case IpoptOutcome::infeasible: return Stop::Reason::infeasible;
  case IpoptOutcome::no_step: return Stop::Reason::no_step;
  default: return {Stop::Reason::other, result.status};
  }
}
} // namespace

void add_jump_entries(const DiscreteProblem &problem,
                      const unsigned int e,
                      const unsigned int r,
                      const double factor,
                      const unsigned int row,
                      std::vector<ConvexProgram::Entry> &entries)
{
  const ContactRow of = problem.row(e, r);
  const DiscreteProblem::Joint &joint = problem.joints()[e];
  for (const int side : {0, 1})
  {
    const unsigned int body = side == 0 ? joint.cell_minus : joint.cell_plus;
    const double sign = side == 0 ? -factor : factor;
    const std::array<double, 3> &turn =
        side == 0 ? of.turn_minus : of.turn_plus;
    const unsigned int T = problem.n_translations();
    for (unsigned int i = 0; i < T; ++i)
      entries.push_back({row, problem.dof(body, i), sign * of.direction[i]});
    for (unsigned int i = T; i < problem.n_unknowns(); ++i)
      entries.push_back({row, problem.dof(body, i), sign * turn[i - T]});
  }
}

void add_opening_entries(const DiscreteProblem &problem,
                         std::vector<ConvexProgram::Entry> &entries)
{
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r)
      add_jump_entries(problem, e, r, 1., problem.first_contact(e) + r,
                       entries);
}

void set_normal_forces(const DiscreteProblem &problem,
                       const std::vector<double> &multipliers,
                       std::vector<double> &forces)
{
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    std::copy_n(multipliers.begin() + problem.first_contact(e),
                problem.n_contacts(e), forces.begin() + problem.first_row(e));
}

ProgramResult solve_program(const DiscreteProblem &problem,
                            DisplacementProgram &program,
                            IpoptControls controls,
                            Terminal &terminal)
{
  controls.held = held_unknowns(problem);
  controls.loose = loose_unknowns(problem);
  std::vector<double> start = program.start();
  hold_bodies(problem, start);

  ProgramResult result;
  Solution &solution = result.solution;
  bool has_doubted = false;
  const auto look_for_collapse = [&] {
    has_doubted = true;
    solution.mechanism = find_collapse(problem, terminal);
  };
  const auto stops = [&](const unsigned int iteration,
                         const std::vector<double> &x) {
    if (problem.is_plane())
      solution.mechanism = find_mechanism(
          problem,
          std::vector<double>(x.begin(), x.begin() + problem.n_dofs()));
    if (!solution.mechanism && !has_doubted && iteration >= n_before_doubt)
      look_for_collapse();
    if (!solution.mechanism)
      solution.stop = program.verdict(iteration);
    return solution.mechanism || solution.stop != Stop::Reason::not_stopped;
  };
  IpoptResult found =
      solve_with_ipopt(program, std::move(start), controls, stops, terminal);
  result.x = std::move(found.x);
  result.multipliers = std::move(found.multipliers);
  solution.n_iterations = found.n_iterations;
  solution.n_evaluations = found.n_evaluations;
  if (found.outcome != IpoptOutcome::stopped)
    solution.stop = stop_of(found);

  if (!solution.converged() && !solution.mechanism && !has_doubted)
    look_for_collapse();
  if (solution.mechanism)
    solution.stop = Stop::Reason::collapse;
  else if (result.x.empty())
    throw SolverError("Ipopt " + solution.stop.words() +
                      " before its first iteration. Try 'Formulation = least "
                      "energy', which does without Ipopt.");
  return result;
}
} // namespace Voussoir
