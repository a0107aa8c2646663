// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/ranges/greatest_force.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace Voussoir
{
namespace
{
/**
 * The unit of values, over that of loads: SelfDual starts well where a motion
 * with the work one is small.
 */
constexpr double size_of_unit = 100.;
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
              Terminal &terminal)
      : forces(problem.rows(), problem.forces().held_bodies(), c),
        terminal(terminal)
  {
    loads.dead = problem.loads();
    const double size = largest_component(loads.dead);
    unit = size_of_unit * (size > 0. ? size : 1.);
    loads.live.assign(loads.dead.size(), 0.);
    loads.dead.push_back(0.);
    loads.live.push_back(-unit);
    loads.sense = 1.;
  }

  StateProgram::Optimum find();

private:
  void look_near(const SelfDual::Point &point);
  double bound_of(const std::vector<double> &u) const;
  double share_for(double distance, double alpha) const;
  double wanted(double alpha) const
  {
    return wanted_width * std::max(1. / size_of_unit, std::abs(alpha));
  }
  bool is_done() const
  {
    return !best.x.empty() && !best.u.empty() &&
           least_bound - greatest <= wanted(greatest);
  }

  BoundedForces forces;
  SelfDual::Loads loads;
  /** The value is that times alpha. */
  double unit;
  Terminal &terminal;
  std::optional<FactorState> anchor;
  std::optional<FactorMotion> open;
  /** Of the best state and of the best motion, over the unit. */
  double greatest = -std::numeric_limits<double>::infinity(),
         least_bound = std::numeric_limits<double>::infinity();
  StateProgram::Optimum best;
};

/** The bound of alpha that a mechanism proves, with the work one of f_1. */
double ForceSearch::bound_of(const std::vector<double> &u) const
{
  const std::vector<double> along = forces.along(u);
  double bound = -dot(loads.dead, u);
  for (const BoundedForces::Bound &b : forces.bounds())
    bound += b.limit * std::max(0., -b.sign * along[b.row]);
  return bound / dot(loads.live, u);
}

/** The share of an anchor that far away. */
double ForceSearch::share_for(const double distance, const double alpha) const
{
  return std::min(largest_share_of_width,
                  share_of_width * wanted(alpha) / std::abs(distance));
}

void ForceSearch::look_near(const SelfDual::Point &point)
{
  // What is not a number proves nothing.
  const InvalidOperationsAllowed allowed;
  FactorState state = state_near(
      forces, loads, point, anchor,
      anchor ? share_for(anchor->alpha - point.alpha, point.alpha) : 0.);
  if (state.residual > largest_residual_of_state && anchor)
    state = state_near(forces, loads, point);
  if (state.residual <= largest_residual_of_state && state.alpha > greatest)
  {
    greatest = state.alpha;
    best.x = std::move(state.x);
  }
  FactorMotion motion = mechanism_near(
      forces, loads, point, open,
      open ? share_for(bound_of(open->u) - point.alpha, point.alpha) : 0.);
  if (motion.closing > largest_closing_of_force && open)
    motion = mechanism_near(forces, loads, point);
  const double bound = bound_of(motion.u);
  if (motion.closing <= largest_closing_of_force && bound < least_bound)
  {
    least_bound = bound;
    best.u = std::move(motion.u);
  }
}

StateProgram::Optimum ForceSearch::find()
{
  SelfDual program(forces, loads);
  std::optional<SelfDual::Point> nearest;
  SelfDual::State state = SelfDual::State::running;
  double least = merit_worth_correcting;
  unsigned int last_trial = 0, last_gain = 0;
  while (state == SelfDual::State::running && !is_done() &&
         program.n_iterations() <
             std::min(n_max_force_steps, last_gain + n_patience_of_force))
  {
    state = program.step();
    terminal.iteration("Range",
                       text("iteration ", program.n_iterations(), ", force ",
                            program.alpha(), " of the largest load, error ",
                            program.merit()));
    if (!nearest)
      last_gain = program.n_iterations();
    if (!(program.merit() < least))
      continue;
    last_gain = program.n_iterations();
    least = program.merit();
    nearest = program.point();
    if (!anchor)
      if (FactorState early = state_near(forces, loads, *nearest);
          early.residual <= largest_residual_of_state)
        anchor = std::move(early);
    if (!open)
      if (FactorMotion early = mechanism_near(forces, loads, *nearest);
          early.closing <= largest_closing_of_force_anchor)
        open = std::move(early);
    if (least > first_trial_force * wanted_width ||
        program.n_iterations() < last_trial + n_between_forces)
      continue;
    last_trial = program.n_iterations();
    look_near(*nearest);
  }
  if (state == SelfDual::State::unbounded)
    return {true, true, program.point().x, {}};
  if (nearest && !is_done())
    look_near(*nearest);
  best.is_found = !best.x.empty() && !best.u.empty();
  if (!best.is_found)
    return best;
  // In units of the jumps c.
  const double size = -best.u.back();
  best.u.pop_back();
  for (double &component : best.u)
    component /= size;
  return std::move(best);
}
} // namespace

StateProgram::Optimum greatest_force(const RowProblem &problem,
                                     const std::vector<double> &c,
                                     Terminal &terminal)
{
  return ForceSearch(problem, c, terminal).find();
}
} // namespace Voussoir
