// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/extreme_rays.h>
#include <voussoir/statics/factor_bounds.h>
#include <voussoir/statics/formulation.h>
#include <voussoir/statics/load_factor.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/** The error, over the wanted width, below which proofs are tried. */
constexpr double first_trial = 30.;
/** The steps between two trials, until the error is as wanted. */
constexpr unsigned int n_between = 2;
/** The largest error with which a point is kept in case no better one comes. */
constexpr double worth_keeping = 1e-2;

/** The part of the wanted width that the anchor of a state may take. */
constexpr double share_of_anchor = 0.05;

/** The largest errors of a state and of a mechanism that are proofs. */
constexpr double largest_residual = 1e-11, largest_closing = 1e-12;

/** The loads and joints of both scenes in common units. */
class Problem
{
public:
  Problem(const Scene &dead, const Scene &live)
      : dead(dead), live(live), units(dead.is_loaded() ? dead : live),
        rays(units), forces(rays, held(units)), of_dead(units.loads_of(dead)),
        of_live(units.loads_of(live))
  {
    forces.clear_held(of_dead);
    forces.clear_held(of_live);
    const double dead_size = largest_component(of_dead);
    const double live_size = largest_component(of_live);
    if (dead_size > 0. && live_size > 0.)
      unit_of_factor = dead_size / live_size;
    for (double &load : of_live)
      load *= unit_of_factor;
  }

  SelfDual::Loads with_factor(const double sense) const
  {
    return {of_dead, of_live, sense};
  }
  SelfDual::Loads at(const double factor) const
  {
    SelfDual::Loads loads = {of_dead, {}, 1.};
    add(loads.dead, factor / unit_of_factor, of_live);
    return loads;
  }
  double factor(const double alpha) const { return alpha * unit_of_factor; }
  bool has_dead_loads() const { return largest_component(of_dead) > 0.; }
  bool has_live_loads() const { return largest_component(of_live) > 0.; }
  InterfaceForces forces_of(const std::vector<double> &x) const
  {
    Solution solution;
    solution.forces = rays.forces_of(x);
    return dimensional_forces(units, solution);
  }
  Motion motion_of(std::vector<double> u) const
  {
    const double size = largest_component(u);
    for (double &component : u)
      component /= size;
    units.hold_bodies(u);
    return units.motion_of_cells(u, units.length_scale());
  }

  const Scene &dead, &live;
  const DiscreteProblem units;
  const ExtremeRays rays;
  BoundedForces forces;

private:
  static std::vector<bool> held(const DiscreteProblem &problem)
  {
    std::vector<bool> result(problem.n_bodies());
    for (unsigned int b = 0; b < result.size(); ++b)
      result[b] = problem.is_held(b);
    return result;
  }

  std::vector<double> of_dead, of_live;
  double unit_of_factor = 1.;
};

/** The proofs found so far. */
class Proofs
{
public:
  Proofs(Problem &problem, const SelfDual::Loads &loads)
      : problem(problem), loads(loads)
  {
    found.carried = -loads.sense * std::numeric_limits<double>::infinity();
    found.bound = loads.sense * std::numeric_limits<double>::infinity();
  }

  /** Keep a state that is far from the bounds. */
  void set_anchor(FactorState state) { anchor = std::move(state); }
  bool has_anchor() const { return anchor.has_value(); }

  void look_near(const SelfDual::Point &point, const double share_of_anchor)
  {
    // What is not a number proves nothing below.
    const InvalidOperationsAllowed allowed;
    FactorState state = state_near(problem.forces, loads, point);
    if (state.residual > largest_residual && anchor)
      state = state_near(problem.forces, loads, point, anchor, share_of_anchor);
    const double carried = problem.factor(state.alpha);
    if (state.residual <= largest_residual &&
        loads.sense * (carried - found.carried) > 0.)
    {
      found.carried = carried;
      found.forces = problem.forces_of(state.x);
    }
    Motion motion =
        problem.motion_of(mechanism_near(problem.forces, loads, point));
    const FactorBound proof =
        bound_of_factor(problem.dead, problem.live, motion);
    if (proof.closing_violation <= largest_closing &&
        loads.sense * proof.live_work > 0. &&
        loads.sense * (found.bound - proof.factor) > 0.)
    {
      found.bound = proof.factor;
      found.mechanism = std::move(motion);
      found.proof = proof;
    }
  }

  LoadFactor found;

private:
  Problem &problem;
  const SelfDual::Loads &loads;
  std::optional<FactorState> anchor;
};

/** A state of the loads without a factor, or else the collapse of them. */
struct Fixed
{
  std::optional<FactorState> state;
  Motion collapse;
  unsigned int n_iterations = 0;
};

void show(const SelfDual &program, const Problem &problem, Terminal &terminal)
{
  terminal.iteration("Load factor",
                     text("iteration ", program.n_iterations(), ", factor ",
                          problem.factor(program.alpha()), ", error ",
                          program.merit()));
}

/** A mechanism of the dead loads, along which the live loads do no work. */
Motion
collapse_of(Problem &problem, SelfDual::Loads loads, const SelfDual &program)
{
  loads.sense = 0.;
  SelfDual::Point ray = program.point();
  const double size = largest_component(ray.u);
  for (auto *const v : {&ray.u, &ray.z})
    for (double &component : *v)
      component /= size;
  Motion motion = problem.motion_of(mechanism_near(problem.forces, loads, ray));
  return motion;
}

/** Forces that balance the loads, without a factor. */
Fixed carry(Problem &problem,
            const double factor,
            const LoadFactorControls &controls,
            Terminal &terminal)
{
  const SelfDual::Loads loads = problem.at(factor);
  Fixed result;
  if (!(largest_component(loads.dead) > 0.))
  {
    result.state =
        FactorState{std::vector<double>(problem.rays.n_all_rows(), 0.), 0., 0.};
    return result;
  }
  SelfDual program(problem.forces, loads);
  SelfDual::State state = SelfDual::State::running;
  while (state == SelfDual::State::running && !result.state &&
         program.n_iterations() < controls.n_max_iterations)
  {
    state = program.step();
    show(program, problem, terminal);
    if (program.merit() < worth_keeping)
    {
      FactorState near = state_near(problem.forces, loads, program.point());
      if (near.residual <= largest_residual)
        result.state = std::move(near);
    }
  }
  if (state == SelfDual::State::infeasible)
    result.collapse = collapse_of(problem, loads, program);
  result.n_iterations = program.n_iterations();
  return result;
}
} // namespace

double LoadFactor::width() const
{
  if (!std::isfinite(carried) || !std::isfinite(bound))
    return std::numeric_limits<double>::infinity();
  const double size = std::max(std::abs(carried), std::abs(bound));
  return size > 0. ? std::abs(bound - carried) / size : 0.;
}

LoadFactorAnswer find_load_factor(const Scene &dead,
                                  const Scene &live,
                                  const LoadFactorControls &controls,
                                  Terminal &terminal)
{
  Problem problem(dead, live);
  if (!problem.has_live_loads())
    throw InputError("'Analysis' is 'load factor', and there are no loads to "
                     "be multiplied: 'Live loads' gives them, or 'Loads' with "
                     "'Load factor/Factor = all loads'.");
  const SelfDual::Loads loads =
      problem.with_factor(controls.greatest ? 1. : -1.);
  Proofs proofs(problem, loads);
  LoadFactorAnswer answer;
  unsigned int n_before = 0;
  if (problem.has_dead_loads())
  {
    Fixed at_rest = carry(problem, 0., controls, terminal);
    n_before = at_rest.n_iterations;
    if (!at_rest.collapse.displacement.empty())
    {
      answer.collapse = std::move(at_rest.collapse);
      return answer;
    }
    if (at_rest.state)
      proofs.set_anchor(std::move(*at_rest.state));
  }

  SelfDual program(problem.forces, loads);
  SelfDual::State state = SelfDual::State::running;
  std::optional<SelfDual::Point> best;
  double least = worth_keeping;
  unsigned int last_trial = 0;
  bool is_proven = false;
  while (state == SelfDual::State::running && !is_proven &&
         program.n_iterations() < controls.n_max_iterations)
  {
    state = program.step();
    show(program, problem, terminal);
    if (!(program.merit() < least))
      continue;
    least = program.merit();
    best = program.point();
    if (!proofs.has_anchor())
      if (FactorState early = state_near(problem.forces, loads, *best);
          early.residual <= largest_residual)
        proofs.set_anchor(std::move(early));
    if (least > first_trial * controls.tolerance ||
        (program.n_iterations() < last_trial + n_between &&
         least > controls.tolerance))
      continue;
    last_trial = program.n_iterations();
    proofs.look_near(*best, share_of_anchor * controls.tolerance);
    best.reset();
    is_proven = proofs.found.width() <= controls.tolerance;
  }
  if (best && !is_proven)
    proofs.look_near(*best, share_of_anchor * controls.tolerance);

  LoadFactor found = std::move(proofs.found);
  found.n_iterations = n_before + program.n_iterations();
  found.stop = found.width() <= controls.tolerance ? Stop::Reason::converged
               : program.n_iterations() >= controls.n_max_iterations
                   ? Stop::Reason::most_iterations
                   : Stop::Reason::rounding;
  if (state == SelfDual::State::unbounded)
  {
    const double one = loads.sense;
    Fixed at_one = carry(problem, one, controls, terminal);
    if (at_one.state)
    {
      found.is_unbounded = true;
      found.carried = one;
      found.bound = one * std::numeric_limits<double>::infinity();
      found.stop = Stop::Reason::converged;
      found.forces = problem.forces_of(at_one.state->x);
    }
  }
  if (found.forces.normal.empty())
    throw SolverError(
        text("The load factor was not found: after ",
             counted(found.n_iterations, "iteration"),
             " there are no forces that prove a factor, and the error is ",
             program.merit(),
             ". Look whether the loads in 'Loads' alone are carried, or take "
             "larger 'Solver/Maximum iterations'."));
  answer.factor = std::move(found);
  return answer;
}

StateAnswer find_any_state(const Scene &scene,
                           const unsigned int n_max_iterations,
                           Terminal &terminal)
{
  Problem problem(scene, scene);
  LoadFactorControls controls;
  controls.n_max_iterations = n_max_iterations;
  Fixed found = carry(problem, 0., controls, terminal);
  StateAnswer answer;
  answer.n_iterations = found.n_iterations;
  if (found.state)
    answer.forces = problem.forces_of(found.state->x);
  else if (!found.collapse.displacement.empty())
    answer.collapse = std::move(found.collapse);
  else
    throw SolverError(
        text("Neither forces that carry the loads nor a mechanism were found "
             "after ",
             counted(found.n_iterations, "iteration"),
             ". The load is close to what the packing can carry, or "
             "'Solver/Maximum iterations' is small."));
  return answer;
}
} // namespace Voussoir
