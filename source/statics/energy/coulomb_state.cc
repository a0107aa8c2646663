// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/anderson.h>
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/balance_within_limits.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/energy/coulomb_state.h>
#include <voussoir/statics/problem/coulomb_limits.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
/** A strength with which no joint slides, in units of the loads. */
constexpr double ample_strength = 1e6;
/** The steps that the acceleration remembers. */
constexpr unsigned int depth = 5;
/** The change of a strength, over the largest force, that is none. */
constexpr double small_change = 1e-12;
/** The change with which passes may end without progress. */
constexpr double acceptable_change = 1e-8;
/** The imbalance of the last pass; others have that of the solver. */
constexpr double tolerance_of_last = 1e-13;
constexpr unsigned int n_patience_of_limits = 10;
constexpr unsigned int n_max_passes = 200, n_max_retreats = 8;

/** The passes of the fixed point. */
class FixedPoint
{
public:
  FixedPoint(const DiscreteProblem &problem,
             const Formulation &formulation,
             const SolverControls &controls,
             Terminal &terminal)
      : problem(problem), formulation(formulation), controls(controls),
        terminal(terminal), anderson(depth)
  {
    this->controls.equilibrate = false;
  }

  /** The state, or none, from the state of some strengths. */
  std::optional<Solution> find(const std::vector<double> &limits);
  /** Why there is none. */
  std::string failure() const { return reason; }

private:
  /** The pass with the least change of a strength, over the largest force. */
  struct Best
  {
    double change = std::numeric_limits<double>::infinity();
    Passes passes;
    std::vector<double> limits;
    Solution state;
  };

  bool solve(const std::vector<double> &limits);
  void iterate();
  void polish(const std::vector<double> &limits);
  std::vector<double> needed_limits(const std::vector<double> &own) const;
  std::vector<double> own_limits() const
  {
    return limits_of_coulomb(problem, state.forces);
  }

  const DiscreteProblem &problem;
  const Formulation &formulation;
  SolverControls controls;
  Terminal &terminal;
  Anderson anderson;
  Solution state;
  Best best;
  std::string reason;
  unsigned int iterations = 0, evaluations = 0;
};

bool FixedPoint::solve(const std::vector<double> &limits)
{
  if (!state.u.empty())
    controls.start = &state;
  Solution found =
      formulation.solve(problem.with_tresca(limits), controls, terminal);
  iterations += found.n_iterations;
  evaluations += found.n_evaluations;
  if (found.mechanism || !found.converged())
    return false;
  state = std::move(found);
  return true;
}

/** Balance to rounding, if that can be had. */
void FixedPoint::polish(const std::vector<double> &limits)
{
  controls.tolerance = std::min(controls.tolerance, tolerance_of_last);
  solve(limits);
}

/** The least strengths, of its own at least, with which the state is one. */
std::vector<double>
FixedPoint::needed_limits(const std::vector<double> &own) const
{
  std::vector<double> needed = sizes_of_friction(problem, state.forces);
  for (std::size_t e = 0; e < needed.size(); ++e)
    needed[e] = std::max(needed[e], own[e]);
  return needed;
}

/** Repeat until the strengths are those of their own state. */
void FixedPoint::iterate()
{
  std::vector<double> limits = own_limits(), last = needed_limits(limits);
  double before = best.change;
  unsigned int n_retreats = 0;
  for (unsigned int n = 1; n <= n_max_passes; ++n)
  {
    if (!solve(limits))
    {
      if (++n_retreats > n_max_retreats)
      {
        reason = text("the strengths of pass ", n, " carry nothing");
        return;
      }
      for (std::size_t e = 0; e < limits.size(); ++e)
        limits[e] = 0.5 * (limits[e] + last[e]);
      anderson.restart();
      continue;
    }
    last = limits;
    const std::vector<double> own = own_limits();
    double change = 0.;
    for (std::size_t e = 0; e < own.size(); ++e)
      change = std::max(change, std::abs(own[e] - limits[e]));
    if (const double largest = largest_component(state.forces); largest > 0.)
      change /= largest;
    terminal.iteration("Fixed point", text("pass ", n, ", change ", change));
    if (change < best.change)
      best = {change, {n, before > 0. ? change / before : 0.}, limits, state};
    if (change <= small_change || n > best.passes.n + n_patience_of_limits)
      break;
    before = change;
    limits = anderson.next(limits, own);
    for (std::size_t e = 0; e < limits.size(); ++e)
      limits[e] = std::max(limits[e], 0.);
  }
  reason = text("its strengths still change by ", best.change,
                " of the largest force");
}

std::optional<Solution> FixedPoint::find(const std::vector<double> &limits)
{
  if (!solve(limits))
  {
    reason = "the strengths that it starts from carry nothing";
    return {};
  }
  iterate();
  if (!(best.change <= acceptable_change))
    return {};
  state = std::move(best.state);
  polish(best.limits);
  // The strengths are its own to Best::change only, and forces that slide may
  // be beyond their limits by that.
  state.forces = balance_within_limits(problem, state.forces, terminal);
  state.passes = best.passes;
  state.n_iterations = iterations;
  state.n_evaluations = evaluations;
  return std::move(state);
}

/** The number of places of friction. */
std::size_t n_frictions(const DiscreteProblem &problem)
{
  return sizes_of_friction(problem,
                           std::vector<double>(problem.n_all_rows(), 0.))
      .size();
}
} // namespace

Solution CoulombState::find(const DiscreteProblem &problem,
                            const SolverControls &controls,
                            std::string &failure,
                            Terminal &terminal) const
{
  const auto from = [&](const std::vector<double> &limits) {
    FixedPoint passes(problem, of_passes, controls, terminal);
    std::optional<Solution> found = passes.find(limits);
    failure = passes.failure();
    return found;
  };
  if (std::optional<Solution> found =
          from(std::vector<double>(n_frictions(problem), ample_strength)))
    return std::move(*found);
  // Forces that are admitted are so whether blocks dilate or not: if there are
  // none, the mechanism of those that do is a proof; if there are, their
  // strengths carry the loads.
  Solution any =
      find_state_or_collapse(problem, controls.n_max_iterations, terminal);
  if (!any.converged())
    return any;
  if (std::optional<Solution> found =
          from(limits_of_coulomb(problem, any.forces)))
    return std::move(*found);
  failure +=
      ". Forces that friction admits balance the loads; but where blocks "
      "slide without lifting, no theorem says that such loads are "
      "carried";
  return {};
}

Solution CoulombState::select(const DiscreteProblem &problem,
                              const SolverControls &controls,
                              Terminal &terminal) const
{
  std::string failure;
  Solution found = find(problem, controls, failure, terminal);
  if (!found.converged() && !found.mechanism)
    throw SolverError(
        text("No state with Coulomb's friction was found: ", failure,
             ". Take smaller loads, or set 'Friction/Law = associated "
             "Coulomb'."));
  if (!found.selection.empty())
    found.selection = selection_with(found.selection);
  return found;
}
} // namespace Voussoir
