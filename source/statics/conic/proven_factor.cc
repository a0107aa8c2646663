// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/proven_factor.h>

#include <algorithm>
#include <cmath>
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
constexpr double near_enough_to_leave = 0.5;
/** The part of the wanted width that an anchor may take. */
constexpr double share_of_anchor = 0.01;
/**
 * Where a proof needs more of the anchor: the factor from one share to the
 * next, by which the proof may be too far away, and the largest share.
 */
constexpr double larger_share = 10., largest_inner_share = 0.5;
/** The largest closing of an anchor. */
constexpr double largest_closing_of_anchor = 1e-13;
} // namespace

ProvenFactor::ProvenFactor(ConicForces &forces,
                           SelfDual::Program program_in,
                           const Controls &controls,
                           Terminal &terminal)
    : forces(forces), program(std::move(program_in)), controls(controls),
      terminal(terminal)
{
  found.least_bound = program.sense * std::numeric_limits<double>::infinity();
  found.least_merit = merit_worth_correcting;
}

void ProvenFactor::Course::cut(const double least)
{
  stops.erase(
      std::find_if(stops.begin(), stops.end(),
                   [least](const Stop &stop) { return stop.error < least; }),
      stops.end());
}

double ProvenFactor::width() const
{
  if (!found.best_state || !found.best_motion)
    return std::numeric_limits<double>::infinity();
  const double size = std::max({std::abs(found.best_state->alpha),
                                std::abs(found.least_bound), controls.small});
  return size > 0.
             ? std::abs(found.least_bound - found.best_state->alpha) / size
             : 0.;
}

void ProvenFactor::take_known()
{
  if (!known)
    return;
  found.anchor = std::exchange(known, nullptr)();
  found.best_state = found.anchor;
}

void ProvenFactor::find_anchors(const SelfDual::Point &point)
{
  if (!found.anchor)
    if (FactorState early = state_near(forces, program, point);
        early.residual <= largest_residual_of_state)
      found.anchor = std::move(early);
  if (!found.open)
    if (FactorMotion early = mechanism_near(forces, program, point);
        early.closing <= largest_closing_of_anchor)
      found.open = std::move(early);
}

void ProvenFactor::keep(const SelfDual &search)
{
  found.progress = search.where();
  found.has_taken_known = known == nullptr;
  controls.journal->keep(controls.name, json_of(found));
}

void ProvenFactor::go_on(KeptFactor from, SelfDual &search)
{
  if (from.has_taken_known)
    take_known();
  found = std::move(from);
  search.go_on(std::move(found.progress));
}

void ProvenFactor::find(const std::function<bool()> &is_enough)
{
  SelfDual search(forces, program,
                  followed != nullptr && !followed->stops.empty()
                      ? &followed->stops.back().at
                      : nullptr);
  // Of one that follows others the whole course would have to be kept.
  Journal *const journal = followed == nullptr ? controls.journal : nullptr;
  if (journal != nullptr)
    if (const Journal::Json before = journal->find(controls.name);
        !before.is_null())
      go_on(kept_factor_of(before), search);
  bool is_last = false;
  state_of_program = SelfDual::State::running;
  while (state_of_program == SelfDual::State::running && !is_last &&
         !is_enough() && search.n_iterations() < controls.n_max_iterations)
  {
    if (journal != nullptr && journal->is_due())
      keep(search);
    // One step beyond what is wanted costs little and brings many digits.
    is_last = width() <= controls.tolerance;
    state_of_program = search.step();
    terminal.iteration("Load factor",
                       text("iteration ", search.n_iterations(), ", factor ",
                            search.alpha() * controls.unit, ", error ",
                            search.merit()));
    if (followed != nullptr)
      followed->stops.push_back({search.merit(), search.variables()});
    if (!(search.merit() < found.least_merit))
      continue;
    found.least_merit = search.merit();
    found.best = search.point();
    take_known();
    find_anchors(*found.best);
    if (found.least_merit > first_trial_factor * controls.tolerance ||
        (search.n_iterations() < found.last_trial + n_between_factors &&
         found.least_merit > controls.tolerance))
      continue;
    found.last_trial = search.n_iterations();
    look_near(*found.best, near_enough_to_leave);
  }
  iterations += search.n_iterations();
  ray = search.point();
  take_known();
  if (!found.best)
    return;
  look_near(*found.best, 0.);
  if (state_of_program != SelfDual::State::unbounded)
    look_farther(*found.best);
}

/** Look for proofs unless there are some, @p near_enough wanted widths away. */
void ProvenFactor::look_near(const SelfDual::Point &point,
                             const double near_enough)
{
  // What is not a number proves nothing.
  const InvalidOperationsAllowed allowed;
  const double near = near_enough * controls.tolerance *
                      std::max(std::abs(point.alpha), controls.small);
  const double share = share_of_anchor * controls.tolerance;
  if (!(program.sense * (point.alpha - alpha_of_carried()) <= near))
  {
    FactorState state = state_near(forces, program, point, found.anchor, share);
    if (state.residual > largest_residual_of_state && found.anchor)
      state = state_near(forces, program, point);
    keep_if_carried(std::move(state));
  }
  if (!(program.sense * (found.least_bound - point.alpha) <= near))
  {
    FactorMotion motion =
        mechanism_near(forces, program, point, found.open, share);
    if (motion.closing > largest_closing_of_factor && found.open)
      motion = mechanism_near(forces, program, point);
    keep_if_bound(std::move(motion));
  }
}

/**
 * Where a point is too far from the optimum for a proof near it, take larger
 * shares of the anchors, up to these alone; the proof is that much nearer to
 * them.
 */
void ProvenFactor::look_farther(const SelfDual::Point &point)
{
  const InvalidOperationsAllowed allowed;
  const double least = larger_share * share_of_anchor * controls.tolerance;
  for (double share = least;
       found.anchor && !found.has_state && share <= largest_inner_share;
       share *= larger_share)
    keep_if_carried(state_near(forces, program, point, found.anchor, share));
  if (found.anchor && !found.has_state)
    keep_if_carried(*found.anchor);
  for (double share = least;
       found.open && !found.best_motion && share <= largest_inner_share;
       share *= larger_share)
    keep_if_bound(mechanism_near(forces, program, point, found.open, share));
  if (found.open && !found.best_motion)
    keep_if_bound(*found.open);
}

void ProvenFactor::keep_if_carried(FactorState near)
{
  if (near.residual <= largest_residual_of_state &&
      program.sense * (near.alpha - alpha_of_carried()) > 0.)
  {
    found.best_state = std::move(near);
    found.has_state = true;
  }
}

/** What is dissipated less the work of the dead loads, over that of the live.*/
void ProvenFactor::keep_if_bound(FactorMotion motion)
{
  const ForceRows &rows = forces.of();
  const double live_work = dot(program.live, motion.u);
  const double bound = (rows.dissipation_of_jumps(rows.jumps(motion.u)) -
                        dot(program.dead, motion.u)) /
                       live_work;
  if (!(motion.closing <= largest_closing_of_factor &&
        program.sense * live_work > 0. &&
        program.sense * (found.least_bound - bound) > 0.))
    return;
  found.least_bound = bound;
  found.best_motion = std::move(motion);
}

std::optional<FactorMotion> ProvenFactor::mechanism_of_all()
{
  SelfDual::Program without_live_work = program;
  without_live_work.sense = 0.;
  if (state_of_program == SelfDual::State::unbounded)
  {
    SelfDual search(forces, without_live_work);
    SelfDual::State state = SelfDual::State::running;
    while (state == SelfDual::State::running &&
           search.n_iterations() < controls.n_max_iterations)
      state = search.step();
    iterations += search.n_iterations();
    if (state != SelfDual::State::infeasible)
      return {};
    ray = search.point();
  }
  const double size = largest_component(ray.u);
  for (auto *const v : {&ray.u, &ray.z})
    for (double &component : *v)
      component /= size;
  return mechanism_near(forces, without_live_work, ray);
}
} // namespace Voussoir
