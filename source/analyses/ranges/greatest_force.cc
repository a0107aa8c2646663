// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/ranges/greatest_force.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
/** The distance of state and motion, over loads or value, to stop at. */
constexpr double wanted_width = 1e-10;
/** The error, over that, below which proofs are tried; steps between trials. */
constexpr double first_trial_force = 1e4;
constexpr unsigned int n_between_forces = 2;
/** The part of the width that an anchor may take, and the largest of it. */
constexpr double share_of_width = 0.2, largest_share_of_width = 0.01;
/** The largest closing of a motion that is a proof, and of its anchor. */
constexpr double largest_closing_of_force = 1e-12,
                 largest_closing_of_force_anchor = 1e-13;
constexpr unsigned int n_max_force_steps = 300;
/** Steps without a lesser error that end the search. */
constexpr unsigned int n_patience_of_force = 10;

/** One search; an object is used once. */
class ForceSearch
{
public:
  ForceSearch(const RowProblem &problem,
              const std::vector<double> &c,
              std::optional<FactorState> anchor,
              Terminal &terminal)
      : forces(problem.rows(), problem.forces().held_bodies()),
        c(c), program{problem.loads()},
        size(largest_component(program.dead) > 0.
                 ? largest_component(program.dead)
                 : 1.),
        terminal(terminal), anchor(std::move(anchor))
  {
    for (const double coefficient : c)
      program.cost.push_back(-coefficient);
    forces.clear_without_force(program.cost);
    // Without loads no force is a state, and less than that of one is rounding.
    if (!(largest_component(program.dead) > 0.))
    {
      best.x.assign(c.size(), 0.);
      greatest = 0.;
      least_gain = wanted(0.);
    }
  }

  StateProgram::Optimum find();

private:
  void look_near(const SelfDual::Point &point);
  double bound_of(const std::vector<double> &u) const
  {
    std::vector<double> jumps = forces.of().jumps(u);
    add(jumps, 1., c);
    return forces.of().dissipation_of_jumps(jumps) - dot(program.dead, u);
  }
  double share_for(double distance, double value) const;
  double wanted(const double value) const
  {
    return wanted_width * std::max(size, std::abs(value));
  }
  bool is_done() const
  {
    return !best.x.empty() && !best.u.empty() &&
           least_bound - greatest <= wanted(greatest);
  }

  ConicForces forces;
  const std::vector<double> &c;
  SelfDual::Program program;
  /** The largest load; without any the unit of forces. */
  const double size;
  Terminal &terminal;
  std::optional<FactorState> anchor;
  std::optional<FactorMotion> open;
  /** Of the best state and of the best motion. */
  double greatest = -std::numeric_limits<double>::infinity(),
         least_bound = std::numeric_limits<double>::infinity();
  /** By how much a state must have more to be better. */
  double least_gain = 0.;
  StateProgram::Optimum best;
};

/** The share of an anchor that far away. */
double ForceSearch::share_for(const double distance, const double value) const
{
  return std::min(largest_share_of_width,
                  share_of_width * wanted(value) / std::abs(distance));
}

void ForceSearch::look_near(const SelfDual::Point &point)
{
  // What is not a number proves nothing.
  const InvalidOperationsAllowed allowed;
  const double value = dot(c, point.x);
  FactorState state =
      state_near(forces, program, point, anchor,
                 anchor ? share_for(dot(c, anchor->x) - value, value) : 0.);
  if (state.residual > largest_residual_of_state && anchor)
    state = state_near(forces, program, point);
  if (const double of_state = dot(c, state.x);
      state.residual <= largest_residual_of_state &&
      of_state > greatest + least_gain)
  {
    greatest = of_state;
    best.x = std::move(state.x);
  }
  FactorMotion motion =
      mechanism_near(forces, program, point, open,
                     open ? share_for(bound_of(open->u) - value, value) : 0.);
  if (motion.closing > largest_closing_of_force && open)
    motion = mechanism_near(forces, program, point);
  const double bound = bound_of(motion.u);
  if (motion.closing <= largest_closing_of_force && bound < least_bound)
  {
    least_bound = bound;
    best.u = std::move(motion.u);
  }
}

StateProgram::Optimum ForceSearch::find()
{
  SelfDual search(forces, program);
  std::optional<SelfDual::Point> nearest;
  SelfDual::State state = SelfDual::State::running;
  double least = merit_worth_correcting;
  unsigned int last_trial = 0, last_gain = 0;
  while (state == SelfDual::State::running && !is_done() &&
         search.n_iterations() <
             std::min(n_max_force_steps, last_gain + n_patience_of_force))
  {
    state = search.step();
    terminal.iteration("Range", text("iteration ", search.n_iterations(),
                                     ", force ", -search.objective(),
                                     " of the unit, error ", search.merit()));
    if (!nearest)
      last_gain = search.n_iterations();
    if (!(search.merit() < least))
      continue;
    last_gain = search.n_iterations();
    least = search.merit();
    nearest = search.point();
    if (!anchor)
      if (FactorState early = state_near(forces, program, *nearest);
          early.residual <= largest_residual_of_state)
        anchor = std::move(early);
    if (!open)
      if (FactorMotion early = mechanism_near(forces, program, *nearest);
          early.closing <= largest_closing_of_force_anchor)
        open = std::move(early);
    if (least > first_trial_force * wanted_width ||
        search.n_iterations() < last_trial + n_between_forces)
      continue;
    last_trial = search.n_iterations();
    look_near(*nearest);
  }
  if (state == SelfDual::State::unbounded)
    return {true, true, search.point().x, {}};
  if (nearest && !is_done())
    look_near(*nearest);
  best.is_found = !best.x.empty() && !best.u.empty();
  return std::move(best);
}
} // namespace

StateProgram::Optimum greatest_force(const RowProblem &problem,
                                     const std::vector<double> &c,
                                     std::optional<FactorState> anchor,
                                     Terminal &terminal)
{
  return ForceSearch(problem, c, std::move(anchor), terminal).find();
}
} // namespace Voussoir
