// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/factors/collapse_pair.h>
#include <voussoir/analyses/factors/factor_without_dilatancy.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/proofs/space_certificate.h>
#include <voussoir/statics/conic/balance_within_limits.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/problem/coulomb_limits.h>
#include <voussoir/statics/problem/discretise.h>
#include <voussoir/statics/problem/discretise_space.h>
#include <voussoir/statics/problem/equilibrate.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
/** The distance of a factor with a state from one without, over the bound. */
constexpr double smallest_width = 1e-6;
/** The same where states end below a collapse that was found. */
constexpr double width_of_end = 1e-4;

/**
 * The factors that are tried, as shares: of a collapse that was found; of the
 * way from there to the bound; of the bound, if none was found.
 */
const std::vector<double> shares_of_collapse = {
    0., 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 0.9, 0.99};
const std::vector<double> shares_of_way = {0.25, 0.5, 0.75, 1.};
const std::vector<double> shares_of_bound = {0.,    0.125, 0.25,  0.375, 0.5,
                                             0.625, 0.75,  0.875, 1.};

/** The iterations of all programmes of a collapse, over those of a solver. */
constexpr unsigned int n_times_of_collapse = 10;
/** The closing of its motion that is rounding, over its size. */
constexpr double largest_closing_of_collapse = 1e-10;
/** The difference of what it proves from its factor, over the bound. */
constexpr double largest_error_of_collapse = 1e-4;
/** The imbalance of its forces, and their excess, that is rounding. */
constexpr double largest_imbalance = 1e-11;
/**
 * A factor with forces within all limits, over that of a collapse, and the
 * shares of these that are tried.
 */
constexpr double share_of_inner = 0.9;
constexpr double shares_of_blend[] = {0., 1e-6, 1e-5, 1e-4};

/** The search for states at factors of the live loads; see CoulombState. */
template <typename SceneOf>
class StatesAtFactors
{
public:
  using MotionOfBlocks = typename SceneOf::MotionOfBlocks;
  StatesAtFactors(const SceneOf &dead,
                  const SceneOf &live,
                  const CoulombState &formulation,
                  const SolverControls &controls,
                  const double sense,
                  Terminal &terminal)
      : dead_scene(dead), live_scene(live),
        problem(discretise(dead.is_loaded() ? dead : live)),
        dead(discretise_loads(problem, dead)),
        live(discretise_loads(problem, live)), formulation(formulation),
        controls(controls), sense(sense), terminal(terminal)
  {}

  /** Put what was found in the place of the factor with dilatancy. */
  void find(FactorOf<SceneOf> &factor);

private:
  std::vector<double> loads_at(double factor) const
  {
    std::vector<double> loads = dead;
    add(loads, factor, live);
    return loads;
  }
  bool has_state(double factor);
  void look_at(double from, double to, const std::vector<double> &shares);
  void bisect(double carried, double beyond, double width);
  void look_beside(double bound);
  void look_for_end(double bound);
  std::vector<double> balanced(const std::vector<double> &forces,
                               double &alpha);
  void find_collapse(const FactorOf<SceneOf> &factor);
  FactorTrials trials() const;

  const SceneOf &dead_scene, &live_scene;
  const DiscreteProblem problem;
  const std::vector<double> dead, live;
  const CoulombState &formulation;
  const SolverControls &controls;
  const double sense;
  Terminal &terminal;
  /** Those tried, in any order. */
  std::vector<double> with_state, without_state;
  /** The state of the greatest factor that has one. */
  double greatest = -sense * std::numeric_limits<double>::infinity();
  std::optional<Solution> found;
  unsigned int n_iterations = 0;
  /** The collapse, if one was found. */
  std::optional<FactorBound> collapse;
  MotionOfBlocks motion;
};

/** Look for a state, and keep it if it is that of the greatest factor. */
template <typename SceneOf>
bool StatesAtFactors<SceneOf>::has_state(const double factor)
{
  const DiscreteProblem at_factor = problem.with_loads(loads_at(factor));
  std::string failure;
  Solution state = formulation.find(at_factor, controls, failure, terminal);
  n_iterations += state.n_iterations;
  terminal.iteration("Load factor",
                     text("factor ", factor, ": ",
                          state.converged() ? text(state.passes.n, " passes")
                          : state.mechanism ? "collapse"
                                            : "no state, " + failure));
  (state.converged() ? with_state : without_state).push_back(factor);
  if (!state.converged())
    return false;
  if (!found || sense * (factor - greatest) > 0.)
  {
    greatest = factor;
    found = std::move(state);
  }
  return true;
}

template <typename SceneOf>
void StatesAtFactors<SceneOf>::look_at(const double from,
                                       const double to,
                                       const std::vector<double> &shares)
{
  for (const double share : shares)
    has_state(from + share * (to - from));
}

/** Bisect between a factor with a state and one without. */
template <typename SceneOf>
void StatesAtFactors<SceneOf>::bisect(double carried,
                                      double beyond,
                                      const double width)
{
  while (std::abs(beyond - carried) > width)
  {
    const double middle = 0.5 * (carried + beyond);
    (has_state(middle) ? carried : beyond) = middle;
  }
}

/** Look between the greatest factor with a state and the next one. */
template <typename SceneOf>
void StatesAtFactors<SceneOf>::look_beside(const double bound)
{
  double beyond = bound;
  for (const double factor : without_state)
    if (sense * (factor - greatest) > 0. && sense * (beyond - factor) > 0.)
      beyond = factor;
  bisect(greatest, beyond, smallest_width * std::abs(bound));
}

/** Look for the end of the factors that all have states, if there is one. */
template <typename SceneOf>
void StatesAtFactors<SceneOf>::look_for_end(const double bound)
{
  double beyond = greatest, carried = 0.;
  for (const double factor : without_state)
    if (sense * (beyond - factor) > 0.)
      beyond = factor;
  if (beyond == greatest)
    return;
  for (const double factor : with_state)
    if (sense * (beyond - factor) > 0. && sense * (factor - carried) > 0.)
      carried = factor;
  if (beyond != 0.)
    bisect(carried, beyond, width_of_end * std::abs(bound));
}

/** The scene with Tresca's friction and the strengths of @p forces. */
Scene with_own_strengths(Scene scene, const InterfaceForces &forces)
{
  for (unsigned int e = 0; e < scene.strength.size(); ++e)
    scene.strength[e] =
        std::max(scene.strength[e] - scene.coefficient[e] * forces.normal[e] /
                                         scene.packing.interfaces()[e].length,
                 0.);
  scene.coefficient.clear();
  scene.dilates = true;
  return scene;
}

/** bound_with_own_strengths() in the plane. */
FactorBound bound_with_own_strengths(const Scene &dead,
                                     const Scene &live,
                                     const InterfaceForces &forces,
                                     const Motion &motion)
{
  return bound_of_factor(with_own_strengths(dead, forces), live, motion);
}

/** @{ */
/** nondimensional_forces() of a scene. */
std::vector<double> forces_of_rows(const DiscreteProblem &problem,
                                   const Scene & /*scene*/,
                                   const InterfaceForces &forces)
{
  return nondimensional_forces(problem, forces);
}
std::vector<double> forces_of_rows(const DiscreteProblem &problem,
                                   const SpaceScene &scene,
                                   const FaceForces &forces)
{
  return nondimensional_forces(problem, scene, forces);
}
/** @} */

/**
 * The forces of a collapse, balanced and within their limits to rounding, if
 * need be with a small share of forces within them at a smaller factor.
 *
 * @param alpha the factor, which becomes that much smaller.
 * @return nothing if that cannot be had.
 */
template <typename SceneOf>
std::vector<double>
StatesAtFactors<SceneOf>::balanced(const std::vector<double> &forces,
                                   double &alpha)
{
  const double of_collapse = alpha, of_inner = share_of_inner * alpha;
  std::vector<double> inner;
  for (const double share : shares_of_blend)
  {
    if (share > 0. && inner.empty())
    {
      const DiscreteProblem at_inner = problem.with_loads(loads_at(of_inner));
      RowProblem by_rows(at_inner);
      const FeasibleForces any = find_feasible_forces(
          by_rows, by_rows.loads(), controls.n_max_iterations, terminal);
      n_iterations += any.n_iterations;
      if (!any.state)
        return {};
      inner = by_rows.rows().forces_of(any.state->x);
    }
    alpha = of_collapse + share * (of_inner - of_collapse);
    std::vector<double> blend = forces;
    for (std::size_t k = 0; k < inner.size(); ++k)
      blend[k] += share * (inner[k] - blend[k]);
    const DiscreteProblem at_factor = problem.with_loads(loads_at(alpha));
    blend = balance_within_limits(at_factor, blend, terminal);
    if (largest_component(imbalance(at_factor, blend)) <= largest_imbalance &&
        excess_of_friction(at_factor, blend) <= largest_imbalance)
      return blend;
  }
  return {};
}

/** Find a collapse from the forces at the factor with dilatancy. */
template <typename SceneOf>
void StatesAtFactors<SceneOf>::find_collapse(const FactorOf<SceneOf> &factor)
{
  std::vector<double> live_of_size_one = live;
  for (double &load : live_of_size_one)
    load *= factor.unit;
  CollapsePair pair = find_collapse_pair(
      problem, dead, live_of_size_one, sense,
      forces_of_rows(problem, dead_scene, factor.forces),
      factor.carried / factor.unit,
      n_times_of_collapse * controls.n_max_iterations, terminal);
  n_iterations += pair.n_iterations;
  if (!pair.is_found)
    return;
  double alpha = pair.alpha * factor.unit;
  Solution state;
  state.forces = balanced(pair.forces, alpha);
  if (state.forces.empty())
    return;
  state.stop = Stop::Reason::converged;
  const typename SceneOf::Forces forces =
      dimensional_forces(problem, dead_scene, state);
  MotionOfBlocks found_motion =
      dimensional_motion(problem, dead_scene, pair.u, 1.);
  const FactorBound proof =
      bound_with_own_strengths(dead_scene, live_scene, forces, found_motion);
  terminal.iteration("Collapse without dilatancy",
                     text("factor ", alpha, ", ", pair.n_programmes,
                          " programmes, its motion proves it to ",
                          std::abs(proof.factor - alpha)));
  if (!(proof.closing_violation <= largest_closing_of_collapse &&
        sense * proof.live_work > 0. &&
        std::abs(proof.factor - alpha) <=
            largest_error_of_collapse * std::abs(factor.bound)))
    return;
  collapse = proof;
  motion = std::move(found_motion);
  with_state.push_back(alpha);
  greatest = alpha;
  found = std::move(state);
}

template <typename SceneOf>
FactorTrials StatesAtFactors<SceneOf>::trials() const
{
  FactorTrials sorted = {with_state, without_state};
  for (auto *const factors : {&sorted.with_state, &sorted.without_state})
    std::sort(factors->begin(), factors->end(),
              [](const double a, const double b) {
                return std::abs(a) < std::abs(b);
              });
  return sorted;
}

template <typename SceneOf>
void StatesAtFactors<SceneOf>::find(FactorOf<SceneOf> &factor)
{
  // A factor that is not known well may have states beyond it.
  const double bound = factor.has_mechanism() && factor.width() > smallest_width
                           ? factor.bound
                           : factor.carried;
  if (bound != 0.)
    find_collapse(factor);
  const double of_collapse = greatest;
  if (collapse)
  {
    look_at(0., of_collapse, shares_of_collapse);
    if (sense * (bound - of_collapse) > smallest_width * std::abs(bound))
      look_at(of_collapse, bound, shares_of_way);
  }
  else if (bound != 0.)
    look_at(0., bound, shares_of_bound);
  else
    has_state(0.);
  if (!found)
    throw SolverError("The load factor was not found: no factor that was tried "
                      "has a state with Coulomb's friction. Look at the loads "
                      "in 'Loads' with 'Analysis = state', or set "
                      "'Friction/Law = associated Coulomb'.");
  if (!collapse || greatest != of_collapse)
    look_beside(bound);
  if (collapse && greatest == of_collapse)
  {
    look_for_end(bound);
    factor.own_collapse = collapse;
    factor.mechanism = std::move(motion);
  }
  factor.carried = greatest;
  factor.trials = trials();
  factor.passes = found->passes;
  factor.n_iterations += n_iterations;
  factor.forces = dimensional_forces(problem, dead_scene, *found);
}
} // namespace

template <typename SceneOf>
FactorAnswerOf<SceneOf>
find_factor_without_dilatancy(const SceneOf &dead,
                              const SceneOf &live,
                              const CoulombState &formulation,
                              const SolverControls &controls,
                              const LoadFactorControls &factor_controls,
                              Terminal &terminal)
{
  FactorAnswerOf<SceneOf> answer =
      find_load_factor(dead, live, factor_controls, terminal);
  // Where pressure alone balances the live loads there is nothing to look for.
  if (answer.factor && !answer.factor->is_unbounded)
    StatesAtFactors<SceneOf>(dead, live, formulation, controls,
                             factor_controls.greatest ? 1. : -1., terminal)
        .find(*answer.factor);
  return answer;
}

template FactorAnswerOf<Scene>
find_factor_without_dilatancy(const Scene &,
                              const Scene &,
                              const CoulombState &,
                              const SolverControls &,
                              const LoadFactorControls &,
                              Terminal &);
template FactorAnswerOf<SpaceScene>
find_factor_without_dilatancy(const SpaceScene &,
                              const SpaceScene &,
                              const CoulombState &,
                              const SolverControls &,
                              const LoadFactorControls &,
                              Terminal &);
} // namespace Voussoir
