// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/ranges/feasible_set.h>
#include <voussoir/analyses/ranges/greatest_force.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/proofs/certificate.h>
#include <voussoir/scene/proofs/space_certificate.h>
#include <voussoir/statics/problem/discretise.h>
#include <voussoir/statics/problem/discretise_space.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
/** What proofs may leave to rounding. */
constexpr double largest_error_of_state = 1e-9, largest_closing = 1e-9,
                 largest_width = 1e-9;
/**
 * The width of proofs by an interior point, which does not end in a vertex; the
 * second where no simplex method can come closer, since sections crush.
 */
constexpr double largest_width_of_interior = 1e-8,
                 largest_width_of_cones = 1e-6;
/**
 * By how much a motion may close joints, over the jumps of the function, at
 * most one: of a motion without bound the errors that are relative to itself
 * prove nothing.
 */
constexpr double largest_closing_of_jumps = 1e-6;
/**
 * What a pressure costs beside the function, in turn, where nothing was proven:
 * between supports that clamp a packing many states have the greatest value,
 * with pressures of any size, and an interior point goes to the largest.
 */
constexpr double costs_of_pressure[] = {0., 1e-9, 1e-8};
/** The iterations to a state away from the limits; it takes about ten. */
constexpr unsigned int n_max_of_anchor = 100;
/** What a ray leaves on a body, over its largest force. */
constexpr double rounding_of_ray = 1e-9;

template <typename MotionOfBlocks>
double largest_displacement(const MotionOfBlocks &motion)
{
  double largest = 0.;
  for (const auto &u : motion.displacement)
    largest = std::max(largest, u.norm());
  return largest;
}

/** @{ */
/** The sizes of the loads on the cells. */
std::vector<double> sizes_of_loads(const Scene &scene)
{
  return largest_loads(scene);
}
std::vector<double> sizes_of_loads(const SpaceScene &scene)
{
  std::vector<double> sizes;
  for (const auto &force : scene.loads.force)
    sizes.push_back(force.norm());
  return sizes;
}
/** @} */

/**
 * Forces near @p x, of any size, that balance by themselves: those that have a
 * limit of their own are nothing beside it, and the others balance to rounding.
 */
std::vector<double> ray_near(const DiscreteProblem &problem,
                             const std::vector<double> &x)
{
  const DiscreteProblem without_limits = problem.with_strengths_up_to(0.);
  RowProblem by_rows(without_limits);
  ConicForces &forces = by_rows.forces();
  SelfDual::Point ray;
  ray.x = x;
  const double size = largest_component(x);
  for (double &force : ray.x)
    force /= size;
  forces.clear_without_force(ray.x);
  ray.s = forces.limits();
  add(ray.s, -1., forces.at_slacks(ray.x));
  ray.alpha = 0.;
  SelfDual::Program nothing;
  nothing.dead.assign(by_rows.rows().n_dofs(), 0.);
  return state_near(forces, nothing, ray).x;
}

/** @{ */
/** A function as one of the forces of the rows. */
std::vector<double> coefficients_of(const Scene & /*scene*/,
                                    const DiscreteProblem &problem,
                                    const ForceRows &rows,
                                    const ForceFunction &function)
{
  std::vector<double> c(rows.n_all_rows(), 0.);
  for (const ForceFunction::Term &term : function.terms)
  {
    const unsigned int n = problem.n_contacts(term.interface);
    for (unsigned int r = 0; r < 2; ++r)
      rows.add_force(term.interface, std::min(r, n - 1),
                     term.at_ends[r] / (n == 1 ? 2. : 1.), c);
    rows.add_force(term.interface, n, term.tangential, c);
  }
  for (const ForceFunction::LinkTerm &term : function.links)
    if (const LinkContact &link = problem.links()[term.link]; link.has_joint())
      rows.add_force(link.joint, 0, link.sign * term.factor, c);
  return c;
}
std::vector<double> coefficients_of(const SpaceScene &scene,
                                    const DiscreteProblem &problem,
                                    const ForceRows & /*rows*/,
                                    const FaceFunction &function)
{
  return discretise_function(problem, scene, function);
}
/** @} */
} // namespace

template <typename SceneOf>
FeasibleSetOf<SceneOf>::FeasibleSetOf(const SceneOf &scene)
    : scene(scene), problem(discretise(scene)), by_rows(problem), force(0.)
{
  for (const double size : sizes_of_loads(scene))
    force = std::max(force, size);
  if (force == 0.)
    force = problem.stress_scale() * problem.length_scale() *
            (problem.is_plane() ? 1. : problem.length_scale());
}

template <typename SceneOf>
StateProgram FeasibleSetOf<SceneOf>::program() const
{
  Assert(are_polyhedral(), dealii::ExcMessage("Sections have curved limits."));
  StateProgram first(by_rows);
  if (!first.find_state())
    throw SolverError("The linear programmes of all states have none to start "
                      "from: the load is close to what the packing can carry. "
                      "Set 'Ranges/Where = 0' and 'Analysis = state' to have "
                      "the state alone.");
  return first;
}

template <typename SceneOf>
std::vector<double>
FeasibleSetOf<SceneOf>::coefficients(const Function &function) const
{
  return coefficients_of(scene, problem, by_rows.rows(), function);
}

template <typename SceneOf>
std::vector<double>
FeasibleSetOf<SceneOf>::with_cost_of_pressure(std::vector<double> c,
                                              const double cost) const
{
  // Forces are negative in compression.
  for (unsigned int e = 0; e < problem.joints().size() && cost > 0.; ++e)
    problem.for_each_pressure(e, [&](const unsigned int r, double) {
      by_rows.rows().add_force(e, r, cost, c);
    });
  return c;
}

template <typename SceneOf>
bool FeasibleSetOf<SceneOf>::is_ray(const std::vector<double> &x) const
{
  // What crushes has a limit too.
  const std::vector<ForceRows::Bounds> &bounds = by_rows.rows().bounds();
  for (std::size_t k = 0; k < x.size(); ++k)
    if (std::isfinite(bounds[k].least) && std::isfinite(bounds[k].greatest) &&
        std::abs(x[k]) > rounding_of_ray * largest_component(x))
      return false;
  return largest_component(by_rows.forces().on_bodies(x)) <=
         rounding_of_ray * largest_component(x);
}

template <typename SceneOf>
bool FeasibleSetOf<SceneOf>::is_proven(const Greatest &value) const
{
  return is_proven(value, largest_width);
}

template <typename SceneOf>
bool FeasibleSetOf<SceneOf>::is_proven(const Greatest &value,
                                       const double largest_width) const
{
  return value.error_of_state <= largest_error_of_state &&
         value.bound.closing_violation <= largest_closing &&
         value.bound.closing_violation * largest_displacement(value.motion) <=
             largest_closing_of_jumps &&
         std::abs(value.width()) <=
             largest_width * std::max(force, std::abs(value.value));
}

template <typename SceneOf>
const std::optional<FactorState> &FeasibleSetOf<SceneOf>::anchor() const
{
  std::call_once(anchor_is_sought, [this]() {
    RowProblem own(problem);
    of_anchor = find_feasible_forces(own, own.loads(), n_max_of_anchor,
                                     Terminal::silent())
                    .state;
  });
  return of_anchor;
}

template <typename SceneOf>
typename FeasibleSetOf<SceneOf>::Greatest
FeasibleSetOf<SceneOf>::found(StateProgram &program,
                              const Function &function) const
{
  const std::vector<double> c = coefficients(function);
  return judged(program.maximise(c), c, function);
}

template <typename SceneOf>
typename FeasibleSetOf<SceneOf>::Greatest
FeasibleSetOf<SceneOf>::judged(StateProgram::Optimum optimum,
                               const std::vector<double> &c,
                               const Function &function) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!optimum.is_found)
    throw SolverError("A linear programme of all states has no answer: the "
                      "load may be close to what the packing can carry. Set "
                      "'Ranges/Where = 0' and 'Analysis = state' to have the "
                      "state alone.");
  if (optimum.is_unbounded)
  {
    if (!is_ray(optimum.x) || !(dot(c, optimum.x) > 0.))
      throw SolverError("A linear programme of all states has no bound, and no "
                        "forces that balance by themselves prove that. Set "
                        "'Ranges/Where = 0' and 'Analysis = state' to have the "
                        "state alone.");
    return {infinity, {infinity, 0.}, 0., {}, {}};
  }
  Solution state;
  state.forces = by_rows.rows().forces_of(optimum.x);
  Greatest found = {};
  found.forces = dimensional_forces(problem, scene, state);
  found.value = function(found.forces);
  found.error_of_state = certify(scene, found.forces).error();
  optimum.u.resize(problem.n_dofs());
  found.motion = dimensional_motion(problem, scene, optimum.u, 1.);
  found.bound = bound_of(scene, function, found.motion);
  return found;
}

/**
 * Now and then Clp ends before the optimum, and goes on if it is asked again;
 * or rounding has spoilt its factors.
 */
template <typename SceneOf>
typename FeasibleSetOf<SceneOf>::Greatest
FeasibleSetOf<SceneOf>::greatest(StateProgram &program,
                                 const Function &function) const
{
  Greatest value = found(program, function);
  if (!is_proven(value))
    value = found(program, function);
  if (!is_proven(value))
  {
    program.forget();
    value = found(program, function);
  }
  if (!is_proven(value))
    throw SolverError(text(
        "The greatest value of a force is not proven: its state has an error "
        "of ",
        value.error_of_state,
        " of the largest load, its motion closes joints by ",
        value.bound.closing_violation, " of its size, and they differ by ",
        value.width(),
        ". Set 'Ranges/Where = 0' and 'Analysis = state' to have the state "
        "alone."));
  return value;
}

template <typename SceneOf>
std::optional<typename FeasibleSetOf<SceneOf>::Greatest>
FeasibleSetOf<SceneOf>::greatest(const Function &function,
                                 Terminal &terminal) const
{
  const std::vector<double> c = coefficients(function);
  for (const double cost : costs_of_pressure)
  {
    StateProgram::Optimum optimum = greatest_force(
        by_rows, with_cost_of_pressure(c, cost), anchor(), terminal);
    if (optimum.is_unbounded)
      optimum.x = ray_near(problem, optimum.x);
    if (!optimum.is_found || (optimum.is_unbounded && !is_ray(optimum.x)))
      continue;
    Greatest value = judged(optimum, c, function);
    if (is_proven(value, are_polyhedral() ? largest_width_of_interior
                                          : largest_width_of_cones))
      return value;
    if (are_polyhedral())
      break; // the simplex method is exact
  }
  return {};
}

template class FeasibleSetOf<Scene>;
template class FeasibleSetOf<SpaceScene>;
} // namespace Voussoir
