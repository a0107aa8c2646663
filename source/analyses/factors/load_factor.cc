// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/factors/changed_strengths.h>
#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/analyses/factors/no_live_loads.h>
#include <voussoir/base/beside.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/proofs/space_certificate.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/problem/discretise.h>
#include <voussoir/statics/problem/discretise_space.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <future>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/** Where there is no greatest factor: the step to a greater one, and the end.*/
constexpr double larger_alpha = 10., largest_alpha = 1e6;

/** A factor, over LoadFactor::unit, that is none. */
constexpr double small_load_factor = 1e-3;
/** The same where there are no dead loads: forces at it are rounding. */
constexpr double rounding_of_load_factor = 1e-12;

/**
 * The largest force that a joint bears without pressure, over the loads, with
 * which the search keeps all its digits, and what stronger joints are taken for
 * at first: they hardly ever slide.
 */
constexpr double largest_plain_limit = 1e6, sufficient_limit = 1e4;

/** The name of a search in a journal. */
const std::string load_factor_name = "load factor";

/** The joints from which on the dead loads have a thread of their own. */
constexpr std::size_t n_joints_of_a_thread = 1024;

/**
 * The problem of the dead loads; without any of the live ones, whose own size
 * means nothing, with forces in units of what joints bear by themselves.
 */
template <typename SceneOf>
DiscreteProblem problem_of(const SceneOf &dead, const SceneOf &live)
{
  if (dead.is_loaded())
    return discretise(dead);
  const DiscreteProblem problem = discretise(live);
  const double limit = problem.largest_limit();
  return limit > 0. ? problem.in_units_of(limit) : problem;
}

/** One search; an object is used once. */
template <typename SceneOf>
class LoadFactorSearch
{
public:
  using MotionOfBlocks = typename SceneOf::MotionOfBlocks;
  using Forces = typename SceneOf::Forces;
  LoadFactorSearch(const SceneOf &dead,
                   const SceneOf &live,
                   const LoadFactorControls &controls,
                   std::string name,
                   Terminal &terminal);

  FactorAnswerOf<SceneOf> find();

private:
  /** What the dead loads alone do. */
  struct AtRest
  {
    /** Forces far from their limits, if there are any. */
    std::optional<FactorState> forces;
    /** The mechanism in which they collapse, if that is proven. */
    std::optional<MotionOfBlocks> collapse;
    unsigned int n_iterations = 0;
  };
  AtRest look_at_rest(RowProblem &rows, Terminal &shown_by) const;
  ProvenFactor::Controls controls_of_factor() const
  {
    return {controls.tolerance, small_load_factor, controls.n_max_iterations,
            found.unit,         controls.journal,  name};
  }
  MotionOfBlocks motion_of(std::vector<double> u) const
  {
    return dimensional_motion(problem, dead, by_rows.of_size_one(std::move(u)),
                              1.);
  }
  Forces forces_of(const std::vector<double> &x) const;
  void keep(const ProvenFactor &factor);
  void find_unbounded();
  void check_found(const ProvenFactor &factor);

  const SceneOf &dead, &live;
  const LoadFactorControls &controls;
  /** In a journal. */
  const std::string name;
  Terminal &terminal;
  const DiscreteProblem problem;
  RowProblem by_rows;
  /** The live loads are of the size of the dead ones. */
  SelfDual::Program program;
  FactorOf<SceneOf> found;
};

template <typename SceneOf>
LoadFactorSearch<SceneOf>::LoadFactorSearch(const SceneOf &dead,
                                            const SceneOf &live,
                                            const LoadFactorControls &controls,
                                            std::string name,
                                            Terminal &terminal)
    : dead(dead), live(live), controls(controls), name(std::move(name)),
      terminal(terminal), problem(problem_of(dead, live)),
      by_rows(problem), program{by_rows.loads(discretise_loads(problem, dead),
                                              true),
                                by_rows.loads(discretise_loads(problem, live),
                                              false),
                                controls.greatest ? 1. : -1.}
{
  const double live_size = largest_component(program.live);
  if (!(live_size > 0.))
    throw NoLiveLoads("'Analysis' is 'load factor', and there are no loads to "
                      "be multiplied: 'Live loads' gives them, or 'Loads' with "
                      "'Load factor/Factor = all loads'.");
  const double dead_size =
      largest_component(by_rows.loads(discretise_loads(problem, dead), false));
  // Or else those of what joints bear, which are one.
  found.unit = (dead_size > 0. ? dead_size : 1.) / live_size;
  for (double &load : program.live)
    load *= found.unit;
  found.carried = -program.sense * std::numeric_limits<double>::infinity();
  found.bound = program.sense * std::numeric_limits<double>::infinity();
}

template <typename SceneOf>
typename SceneOf::Forces
LoadFactorSearch<SceneOf>::forces_of(const std::vector<double> &x) const
{
  Solution solution;
  solution.forces = by_rows.rows().forces_of(x);
  return dimensional_forces(problem, dead, solution);
}

/** Look whether the dead loads are carried by themselves. */
template <typename SceneOf>
auto LoadFactorSearch<SceneOf>::look_at_rest(RowProblem &rows,
                                             Terminal &shown_by) const -> AtRest
{
  AtRest at_rest;
  if (!dead.is_loaded())
    return at_rest;
  FeasibleForces any = find_feasible_forces(
      rows, program.dead, controls.n_max_iterations, shown_by);
  at_rest.n_iterations = any.n_iterations;
  at_rest.forces = std::move(any.state);
  if (any.collapse.empty())
    return at_rest;
  MotionOfBlocks motion = motion_of(any.collapse);
  if (proves_collapse(certify_mechanism(dead, motion)))
    at_rest.collapse = std::move(motion);
  return at_rest;
}

template <typename SceneOf>
FactorAnswerOf<SceneOf> LoadFactorSearch<SceneOf>::find()
{
  const bool is_beside =
      problem.joints().size() >= n_joints_of_a_thread && has_other_threads();
  const auto look = [&] {
    if (!is_beside)
      return look_at_rest(by_rows, terminal);
    // Matrices of its own, and nothing to be seen between the other's lines.
    RowProblem own(problem);
    return look_at_rest(own, Terminal::silent());
  };
  AtRest at_rest;
  ProvenFactor factor(by_rows.forces(), program, controls_of_factor(),
                      terminal);
  std::future<AtRest> found_at_rest = beside(is_beside, look);
  factor.set_carried([&] {
    at_rest = found_at_rest.get();
    return at_rest.forces;
  });
  factor.find();
  found.n_iterations += at_rest.n_iterations + factor.n_iterations();
  FactorAnswerOf<SceneOf> answer;
  found.collapses_without = at_rest.collapse.has_value();
  if (at_rest.collapse)
    answer.collapse = std::move(*at_rest.collapse);
  keep(factor);
  if (factor.state() == SelfDual::State::unbounded)
    find_unbounded();
  if (factor.state() == SelfDual::State::infeasible ||
      (factor.state() == SelfDual::State::unbounded && !found.is_unbounded))
    if (const std::optional<FactorMotion> motion = factor.mechanism_of_all())
    {
      answer.collapse = motion_of(motion->u);
      answer.collapses_with_any = true;
      return answer;
    }
  if (found.forces.empty() && found.collapses_without)
    return answer; // no factor is known to help
  check_found(factor);
  answer.factor = std::move(found);
  return answer;
}

template <typename SceneOf>
void LoadFactorSearch<SceneOf>::keep(const ProvenFactor &factor)
{
  if (factor.carried())
  {
    found.carried = factor.carried()->alpha * found.unit;
    found.forces = forces_of(factor.carried()->x);
  }
  if (!dead.is_loaded() &&
      !(program.sense * found.carried > rounding_of_load_factor * found.unit))
  {
    // Without loads there is nothing to be carried.
    found.carried = 0.;
    if (factor.carried() || factor.mechanism())
    {
      Solution at_rest;
      at_rest.forces.assign(problem.n_all_rows(), 0.);
      found.forces = dimensional_forces(problem, dead, at_rest);
    }
  }
  if (!factor.mechanism())
    return;
  MotionOfBlocks motion = motion_of(factor.mechanism()->u);
  const FactorBound proof = bound_of_factor(dead, live, motion);
  if (!(proof.closing_violation <= largest_closing_of_factor &&
        program.sense * proof.live_work > 0.))
    return;
  found.bound = proof.factor;
  found.mechanism = std::move(motion);
  found.proof = proof;
}

/**
 * Find forces at a factor beside those that balance the live loads alone: at
 * one, or where live loads are as large as the dead ones, or larger.
 */
template <typename SceneOf>
void LoadFactorSearch<SceneOf>::find_unbounded()
{
  for (double alpha = 1. / found.unit; !found.is_unbounded;
       alpha = std::max(1., larger_alpha * alpha))
  {
    if (alpha > largest_alpha / found.unit && alpha > largest_alpha)
      return;
    std::vector<double> loads = program.dead;
    add(loads, program.sense * alpha, program.live);
    const FeasibleForces any = find_feasible_forces(
        by_rows, loads, controls.n_max_iterations, terminal);
    found.n_iterations += any.n_iterations;
    if (!any.state)
      continue;
    found.is_unbounded = true;
    found.carried = program.sense * alpha * found.unit;
    found.forces = forces_of(any.state->x);
  }
}

/** @throws SolverError if no forces prove a factor. */
template <typename SceneOf>
void LoadFactorSearch<SceneOf>::check_found(const ProvenFactor &factor)
{
  // That the dead loads are carried is an answer only beside a bound.
  if (found.forces.empty() || (factor.carried() && !factor.has_found_state() &&
                               !found.has_mechanism() && !found.is_unbounded))
    throw SolverError(
        text("The load factor was not found: after ",
             counted(found.n_iterations, "iteration"),
             " there are no forces that prove one. Look whether the loads in "
             "'Loads' alone are carried, or take larger 'Solver/Maximum "
             "iterations'."));
  if (found.is_unbounded || found.width() <= controls.tolerance)
    found.stop = Stop::Reason::converged;
  else
    found.stop = factor.n_iterations() >= controls.n_max_iterations
                     ? Stop::Reason::most_iterations
                     : Stop::Reason::rounding;
}
} // namespace

template <typename SceneOf>
double FactorOf<SceneOf>::width() const
{
  if (!std::isfinite(carried) || !std::isfinite(bound))
    return std::numeric_limits<double>::infinity();
  const double size =
      std::max({std::abs(carried), std::abs(bound), small_load_factor * unit});
  return size > 0. ? std::abs(bound - carried) / size : 0.;
}

namespace
{
/**
 * The search with strengths that are as good as those of much stronger joints:
 * forces within lower limits are within the given ones, and what the mechanism
 * proves with these is computed anew.
 */
template <typename SceneOf>
FactorAnswerOf<SceneOf>
find_with_sufficient_strengths(const SceneOf &dead,
                               const SceneOf &live,
                               const double most,
                               const LoadFactorControls &controls,
                               Terminal &terminal)
{
  const auto find = [&](const SceneOf &a, const SceneOf &b) {
    return LoadFactorSearch<SceneOf>(a, b, controls, load_factor_name, terminal)
        .find();
  };
  FactorAnswerOf<SceneOf> inner =
      LoadFactorSearch<SceneOf>(
          with_strengths_up_to(dead, most), with_strengths_up_to(live, most),
          controls, load_factor_name + " of sufficient strengths", terminal)
          .find();
  if (!inner.factor || inner.factor->is_unbounded ||
      !inner.factor->has_mechanism())
    return find(dead, live);
  FactorOf<SceneOf> &found = *inner.factor;
  found.proof = bound_of_factor(dead, live, found.mechanism);
  found.bound = found.proof.factor;
  if (found.width() <= controls.tolerance)
    return inner;
  try
  {
    FactorAnswerOf<SceneOf> outer = find(dead, live);
    if (!outer.factor || outer.factor->is_unbounded)
      return outer;
    const double sense = controls.greatest ? 1. : -1.;
    const FactorOf<SceneOf> &other = *outer.factor;
    if (sense * (other.carried - found.carried) > 0.)
    {
      found.carried = other.carried;
      found.forces = other.forces;
    }
    if (other.has_mechanism() && sense * (found.bound - other.bound) > 0.)
    {
      found.bound = other.bound;
      found.mechanism = other.mechanism;
      found.proof = other.proof;
    }
    found.n_iterations += other.n_iterations;
  }
  catch (const SolverError &)
  {
    // What is known stands: both are proofs.
  }
  found.stop = found.width() <= controls.tolerance ? Stop::Reason::converged
                                                   : Stop::Reason::rounding;
  return inner;
}
} // namespace

template <typename SceneOf>
FactorAnswerOf<SceneOf> find_load_factor(const SceneOf &dead,
                                         const SceneOf &live,
                                         const LoadFactorControls &controls,
                                         Terminal &terminal)
{
  if (dead.is_loaded())
    if (const DiscreteProblem problem = discretise(dead);
        problem.largest_limit() > largest_plain_limit)
      return find_with_sufficient_strengths(
          dead, live, sufficient_limit * problem.stress_scale(), controls,
          terminal);
  return LoadFactorSearch<SceneOf>(dead, live, controls, load_factor_name,
                                   terminal)
      .find();
}

template struct FactorOf<Scene>;
template struct FactorOf<SpaceScene>;
template FactorAnswerOf<Scene> find_load_factor(const Scene &,
                                                const Scene &,
                                                const LoadFactorControls &,
                                                Terminal &);
template FactorAnswerOf<SpaceScene> find_load_factor(const SpaceScene &,
                                                     const SpaceScene &,
                                                     const LoadFactorControls &,
                                                     Terminal &);
} // namespace Voussoir
