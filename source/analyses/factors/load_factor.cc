// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/problem/discretise.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/** The error, over the wanted width, below which proofs are tried. */
constexpr double first_trial_factor = 30.;
/** The steps between two trials, until the error is as wanted. */
constexpr unsigned int n_between_factors = 2;

/** How near a proof is to the factor, over the wanted width, to be left. */
constexpr double near_enough = 0.5;
/** The part of the wanted width that an anchor may take. */
constexpr double share_of_anchor = 0.01;
/**
 * Where a proof needs more of the anchor: the factor from one share to the
 * next, by which the proof may be too far away, and the largest share.
 */
constexpr double larger_share = 10., largest_inner_share = 0.5;

/** A factor, over LoadFactor::unit, that is none. */
constexpr double small_load_factor = 1e-3;

/** The largest closing of a mechanism that is a proof, and of its anchor. */
constexpr double largest_closing_of_factor = 1e-12,
                 largest_closing_of_factor_anchor = 1e-13;

/**
 * The problem of the dead loads; without any of the live ones, whose own size
 * means nothing, with forces in units of what joints bear by themselves.
 */
DiscreteProblem problem_of(const Scene &dead, const Scene &live)
{
  if (dead.is_loaded())
    return discretise(dead);
  const DiscreteProblem problem = discretise(live);
  const double limit = problem.largest_limit();
  return limit > 0. ? problem.in_units_of(limit) : problem;
}

/** The search for a factor, phase by phase. */
class FactorSearch
{
public:
  FactorSearch(const Scene &dead,
               const Scene &live,
               const LoadFactorControls &controls,
               Terminal &terminal);

  /** The mechanism of the dead loads, if they collapse, or else nothing. */
  Motion find_collapse_at_rest();
  Motion motion_of(std::vector<double> u) const;
  /** Look for both proofs. */
  void find_proofs();
  /** What was found. */
  LoadFactor result();

private:
  std::vector<double> loads_at(double factor) const;
  void look_with_rows();
  void look_near(const SelfDual::Point &point, double near_enough);
  void look_farther(const SelfDual::Point &point);
  void keep_at_rest(const Solution &solution);
  void keep_if_carried(const FactorState &state);
  void keep_if_bound(Motion motion);

  const Scene &dead, &live;
  const LoadFactorControls &controls;
  Terminal &terminal;
  const DiscreteProblem problem;
  RowProblem by_rows;
  /** The live loads are of the size of the dead ones. */
  SelfDual::Program loads;
  double unit_of_factor = 1.;
  /** A state far from the bounds, and a motion far from closing joints. */
  std::optional<FactorState> anchor;
  std::optional<FactorMotion> open;
  /** The last point with a small error. */
  std::optional<SelfDual::Point> best;
  SelfDual::State state = SelfDual::State::running;
  /** Forces for the dead loads alone. */
  std::optional<InterfaceForces> at_rest;
  /** True if there are forces at the factor that is carried. */
  bool has_state = false;
  LoadFactor found;
};

FactorSearch::FactorSearch(const Scene &dead,
                           const Scene &live,
                           const LoadFactorControls &controls,
                           Terminal &terminal)
    : dead(dead), live(live), controls(controls), terminal(terminal),
      problem(problem_of(dead, live)),
      by_rows(problem), loads{by_rows.loads(discretise_loads(problem, dead),
                                            true),
                              by_rows.loads(discretise_loads(problem, live),
                                            false),
                              controls.greatest ? 1. : -1.}
{
  const double live_size = largest_component(loads.live);
  if (!(live_size > 0.))
    throw InputError("'Analysis' is 'load factor', and there are no loads to "
                     "be multiplied: 'Live loads' gives them, or 'Loads' with "
                     "'Load factor/Factor = all loads'.");
  const double dead_size =
      largest_component(by_rows.loads(discretise_loads(problem, dead), false));
  // Or else those of what joints bear, which are one.
  unit_of_factor = (dead_size > 0. ? dead_size : 1.) / live_size;
  for (double &load : loads.live)
    load *= unit_of_factor;
  found.unit = unit_of_factor;
  found.carried = -loads.sense * std::numeric_limits<double>::infinity();
  found.bound = loads.sense * std::numeric_limits<double>::infinity();
  if (dead_size > 0.)
    return;
  // Without loads there is nothing to be carried.
  Solution rest;
  rest.forces.resize(problem.n_all_rows());
  keep_at_rest(rest);
}

void FactorSearch::keep_at_rest(const Solution &solution)
{
  found.carried = 0.;
  at_rest = dimensional_forces(problem, solution);
}

std::vector<double> FactorSearch::loads_at(const double factor) const
{
  std::vector<double> sum = loads.dead;
  add(sum, factor / unit_of_factor, loads.live);
  return sum;
}

Motion FactorSearch::find_collapse_at_rest()
{
  if (!(largest_component(loads.dead) > 0.))
    return {};
  FeasibleForces any = find_feasible_forces(
      by_rows, loads_at(0.), controls.n_max_iterations, terminal);
  found.n_iterations += any.n_iterations;
  if (any.state)
  {
    Solution solution;
    solution.forces = by_rows.rows().forces_of(any.state->x);
    keep_at_rest(solution);
  }
  anchor = std::move(any.state);
  return any.collapse.empty() ? Motion() : motion_of(any.collapse);
}

Motion FactorSearch::motion_of(std::vector<double> u) const
{
  return dimensional_motion(problem, by_rows.of_size_one(std::move(u)), 1.);
}

void FactorSearch::find_proofs()
{
  look_with_rows();
  if (state != SelfDual::State::unbounded && best)
    look_farther(*best);
}

void FactorSearch::look_with_rows()
{
  state = SelfDual::State::running;
  SelfDual program(by_rows.forces(), loads);
  best.reset();
  double least = merit_worth_correcting;
  unsigned int last_trial = 0;
  bool is_last = false;
  while (state == SelfDual::State::running && !is_last &&
         program.n_iterations() < controls.n_max_iterations)
  {
    // One step beyond what is wanted costs little and brings many digits.
    is_last = found.width() <= controls.tolerance;
    state = program.step();
    terminal.iteration("Load factor",
                       text("iteration ", program.n_iterations(), ", factor ",
                            program.alpha() * unit_of_factor, ", error ",
                            program.merit()));
    if (!(program.merit() < least))
      continue;
    least = program.merit();
    best = program.point();
    if (!anchor)
      if (FactorState early = state_near(by_rows.forces(), loads, *best);
          early.residual <= largest_residual_of_state)
        anchor = std::move(early);
    if (!open)
      if (FactorMotion early = mechanism_near(by_rows.forces(), loads, *best);
          early.closing <= largest_closing_of_factor_anchor)
        open = std::move(early);
    if (least > first_trial_factor * controls.tolerance ||
        (program.n_iterations() < last_trial + n_between_factors &&
         least > controls.tolerance))
      continue;
    last_trial = program.n_iterations();
    look_near(*best, near_enough);
  }
  if (best)
    look_near(*best, 0.);
  found.n_iterations += program.n_iterations();
  if (program.n_iterations() >= controls.n_max_iterations)
    found.stop = Stop::Reason::most_iterations;
}

/** Look for proofs unless there are some, @p near_enough wanted widths away. */
void FactorSearch::look_near(const SelfDual::Point &point,
                             const double near_enough)
{
  // What is not a number proves nothing.
  const InvalidOperationsAllowed allowed;
  const double factor = point.alpha * unit_of_factor;
  const double near =
      near_enough * controls.tolerance *
      std::max(std::abs(factor), small_load_factor * found.unit);
  const double share = share_of_anchor * controls.tolerance;
  if (!(loads.sense * (factor - found.carried) <= near))
  {
    FactorState state =
        state_near(by_rows.forces(), loads, point, anchor, share);
    if (state.residual > largest_residual_of_state && anchor)
      state = state_near(by_rows.forces(), loads, point);
    keep_if_carried(state);
  }
  if (!(loads.sense * (found.bound - factor) <= near))
  {
    FactorMotion motion =
        mechanism_near(by_rows.forces(), loads, point, open, share);
    if (motion.closing > largest_closing_of_factor && open)
      motion = mechanism_near(by_rows.forces(), loads, point);
    keep_if_bound(motion_of(std::move(motion.u)));
  }
}

/**
 * Where a point is too far from the optimum for a proof near it, take larger
 * shares of the anchors, up to these alone; the proof is that much nearer to
 * them.
 */
void FactorSearch::look_farther(const SelfDual::Point &point)
{
  const InvalidOperationsAllowed allowed;
  const double least = larger_share * share_of_anchor * controls.tolerance;
  for (double share = least;
       anchor && !has_state && share <= largest_inner_share;
       share *= larger_share)
    keep_if_carried(state_near(by_rows.forces(), loads, point, anchor, share));
  if (anchor && !has_state)
    keep_if_carried(*anchor);
  for (double share = least;
       open && !found.has_mechanism() && share <= largest_inner_share;
       share *= larger_share)
    keep_if_bound(motion_of(
        mechanism_near(by_rows.forces(), loads, point, open, share).u));
  if (open && !found.has_mechanism())
    keep_if_bound(motion_of(open->u));
}

void FactorSearch::keep_if_carried(const FactorState &near)
{
  const double carried = near.alpha * unit_of_factor;
  if (!(near.residual <= largest_residual_of_state &&
        loads.sense * (carried - found.carried) > 0.))
    return;
  Solution solution;
  solution.forces = by_rows.rows().forces_of(near.x);
  found.carried = carried;
  found.forces = dimensional_forces(problem, solution);
  has_state = true;
}

void FactorSearch::keep_if_bound(Motion motion)
{
  const FactorBound proof = bound_of_factor(dead, live, motion);
  if (!(proof.closing_violation <= largest_closing_of_factor &&
        loads.sense * proof.live_work > 0. &&
        loads.sense * (found.bound - proof.factor) > 0.))
    return;
  found.bound = proof.factor;
  found.mechanism = std::move(motion);
  found.proof = proof;
}

LoadFactor FactorSearch::result()
{
  if (state == SelfDual::State::unbounded)
  {
    const FeasibleForces at_one = find_feasible_forces(
        by_rows, loads_at(loads.sense), controls.n_max_iterations, terminal);
    found.is_unbounded = at_one.state.has_value();
    if (at_one.state)
    {
      FactorState one = *at_one.state;
      one.alpha = loads.sense / unit_of_factor;
      keep_if_carried(one);
    }
  }
  // That the dead loads are carried is an answer only beside a bound.
  if (!has_state && at_rest && found.has_mechanism())
    found.forces = *at_rest;
  if (found.forces.normal.empty())
    throw SolverError(
        text("The load factor was not found: after ",
             counted(found.n_iterations, "iteration"),
             " there are no forces that prove one. Look whether the loads in "
             "'Loads' alone are carried, or take larger 'Solver/Maximum "
             "iterations'."));
  if (found.is_unbounded || found.width() <= controls.tolerance)
    found.stop = Stop::Reason::converged;
  else if (found.stop == Stop::Reason::not_stopped)
    found.stop = Stop::Reason::rounding;
  return std::move(found);
}
} // namespace

double LoadFactor::width() const
{
  if (!std::isfinite(carried) || !std::isfinite(bound))
    return std::numeric_limits<double>::infinity();
  const double size =
      std::max({std::abs(carried), std::abs(bound), small_load_factor * unit});
  return size > 0. ? std::abs(bound - carried) / size : 0.;
}

LoadFactorAnswer find_load_factor(const Scene &dead,
                                  const Scene &live,
                                  const LoadFactorControls &controls,
                                  Terminal &terminal)
{
  FactorSearch search(dead, live, controls, terminal);
  LoadFactorAnswer answer;
  answer.collapse = search.find_collapse_at_rest();
  if (!answer.collapse.displacement.empty())
    return answer;
  search.find_proofs();
  answer.factor = search.result();
  return answer;
}
} // namespace Voussoir
