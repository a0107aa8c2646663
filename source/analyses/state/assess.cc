// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/state/assess.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/paper/analytic_centre.h>
#include <voussoir/statics/problem/discretise.h>
#include <voussoir/statics/problem/equilibrate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
/**
 * An error of the certificate that is rounding. Displacements add up over the
 * cells across a packing, and their digits are lost to those of the jumps
 * (measured, a million cells: 1e-11, and 1.4e-11 where they turn).
 */
double rounding_of_balance(const Scene &scene)
{
  return std::max(1e-11, 100. * std::numeric_limits<double>::epsilon() *
                             std::sqrt(scene.packing.n_cells()));
}

/**
 * The largest load on a cell of a part that slides, over the forces on its
 * worst cell; heavier cells are held.
 */
constexpr double heavier = 1e3;
/** The largest number of parts for which a proof of collapse is sought. */
constexpr unsigned int n_max_parts = 8;

/**
 * A strength, in units of the loads on a part over its size, with which joints
 * hardly slide: with much higher ones solvers lose digits. A proof found with
 * it must hold with the true strengths.
 */
constexpr double sufficient_strength = 1e3;

/** The most iterations of the analytic centre, and of what follows it. */
constexpr unsigned int n_centre_iterations = 100;

/** The distance of forces from their limits that no accepted error uses up. */
constexpr double slack_beside_errors = 1e-3;

/** The shares of other forces in a correction, tried in turn; at last these
 * alone. */
constexpr std::array<double, 4> shares = {{1e-6, 1e-4, 1e-2, 1.}};

bool is_exact(const Scene &scene, const Certificate &certificate)
{
  return certificate.error() <= rounding_of_balance(scene) &&
         certificate.unbalanced.empty();
}

/** Forces of a state within all limits; empty if none was found. */
std::vector<double> feasible_forces(const DiscreteProblem &problem)
{
  try
  {
    Solution found = FeasibleState().solve(problem, {}, Terminal::silent());
    if (found.converged() && !found.mechanism)
      return std::move(found.forces);
  }
  catch (const SolverError &)
  {}
  return {};
}

/** The forces @p share of the way from @p forces to @p others. */
std::vector<double> mixed(const std::vector<double> &forces,
                          const std::vector<double> &others,
                          const double share)
{
  std::vector<double> mixture = forces;
  for (std::size_t k = 0; k < mixture.size(); ++k)
    mixture[k] += share * (others[k] - forces[k]);
  return mixture;
}

/**
 * Whether a correction makes forces exact: the smallest, or else one towards
 * any state within all limits, which takes forces back that are beyond theirs.
 * Very close to the limit only that state itself may be left, which carries the
 * loads all the same.
 */
bool can_be_balanced(const Scene &scene, const InterfaceForces &forces)
{
  const DiscreteProblem problem = discretise(scene);
  const auto succeeds = [&](std::vector<double> corrected) {
    Solution solution;
    solution.forces = std::move(corrected);
    return is_exact(scene,
                    certify(scene, dimensional_forces(problem, solution)));
  };
  const std::vector<double> corrected = equilibrate(
      problem, nondimensional_forces(problem, forces), slack_beside_errors);
  if (succeeds(corrected))
    return true;
  const std::vector<double> inside = feasible_forces(problem);
  return !inside.empty() &&
         std::any_of(shares.begin(), shares.end(), [&](const double share) {
           return succeeds(mixed(corrected, inside, share));
         });
}

/**
 * Cell @p first and those connected to it by cells with no more than @p load on
 * them.
 */
std::vector<bool>
part_around(const Scene &scene, const unsigned int first, const double load)
{
  const Packing<2> &packing = scene.packing;
  std::vector<std::vector<unsigned int>> neighbours(packing.n_cells());
  const auto connect = [&](const unsigned int one, const unsigned int other) {
    if (other == packing.ground())
      return;
    neighbours[one].push_back(other);
    neighbours[other].push_back(one);
  };
  for (const Packing<2>::Interface &i : packing.interfaces())
    connect(i.cell_minus, i.cell_plus);
  for (const Link &link : scene.links)
    connect(link.cell_minus, link.cell_plus);
  std::vector<bool> part(packing.n_cells(), false);
  std::vector<unsigned int> to_visit = {first};
  part[first] = true;
  while (!to_visit.empty())
  {
    const unsigned int c = to_visit.back();
    to_visit.pop_back();
    for (const unsigned int other : neighbours[c])
      if (!part[other] && scene.load_size[other] <= load)
      {
        part[other] = true;
        to_visit.push_back(other);
      }
  }
  return part;
}

/** The cells of a part that have a load. */
std::vector<bool> loaded_of(const Scene &scene, std::vector<bool> part)
{
  for (unsigned int c = 0; c < part.size(); ++c)
    part[c] = part[c] && scene.load_size[c] > 0.;
  return part;
}

/** The mechanism of the cells that move, if there is one that is a proof. */
Motion collapse_of(const Scene &scene,
                   const std::vector<bool> &moves,
                   const double highest_strength,
                   Terminal &terminal)
{
  const DiscreteProblem problem =
      discretise(scene, moves).with_strengths_up_to(highest_strength);
  if (problem.joints().empty() || !problem.is_loaded())
    return {};
  const auto mechanism = find_collapse(problem, terminal);
  if (!mechanism)
    return {};
  const Motion of_moving = dimensional_motion(problem, *mechanism);
  Motion motion(moves.size(), problem.kinematics());
  for (unsigned int c = 0, k = 0; c < moves.size(); ++c)
    if (moves[c])
    {
      motion.displacement[c] = of_moving.displacement[k];
      if (!motion.rotation.empty())
        motion.rotation[c] = of_moving.rotation[k];
      ++k;
    }
  return proves_collapse(certify_mechanism(scene, motion)) ? motion : Motion();
}

Motion collapse_of_parts(const Scene &scene,
                         const Certificate &certificate,
                         Terminal &terminal)
{
  std::vector<UnbalancedCell> left = certificate.unbalanced;
  for (unsigned int n = 0; n < n_max_parts && !left.empty(); ++n)
  {
    const UnbalancedCell lightest =
        *std::min_element(left.begin(), left.end(),
                          [](const UnbalancedCell &a, const UnbalancedCell &b) {
                            return a.own_force < b.own_force;
                          });
    const std::vector<bool> part =
        part_around(scene, lightest.cell, heavier * lightest.own_force);
    for (const std::vector<bool> &moves : {loaded_of(scene, part), part})
      for (const double highest_strength :
           {std::numeric_limits<double>::infinity(), sufficient_strength})
      {
        Motion found = collapse_of(scene, moves, highest_strength, terminal);
        if (!found.displacement.empty())
          return found;
      }
    left.erase(
        std::remove_if(left.begin(), left.end(),
                       [&](const UnbalancedCell &u) { return part[u.cell]; }),
        left.end());
  }
  return {};
}
} // namespace

Assessment assess(const Scene &scene,
                  const InterfaceForces &forces,
                  const Certificate &certificate,
                  Terminal &terminal)
{
  if (is_exact(scene, certificate))
    return {};
  const double error = certificate.error();
  if (error > largest_accepted_error) // as the user asked for
    return {{Status::Kind::carried_within, error}, {}};
  try
  {
    if (can_be_balanced(scene, forces))
      return {};
    Motion mechanism;
    if (error > rounding_of_balance(scene))
      mechanism =
          collapse_of(scene, std::vector<bool>(scene.packing.n_cells(), true),
                      std::numeric_limits<double>::infinity(), terminal);
    if (mechanism.displacement.empty())
      mechanism = collapse_of_parts(scene, certificate, terminal);
    if (!mechanism.displacement.empty())
      return {{Status::Kind::collapse, 0.}, std::move(mechanism)};
  }
  catch (const SolverError &)
  {
    // Neither was found.
  }
  catch (const std::bad_alloc &)
  {
    // No proof can be found with this memory.
  }
  return {{Status::Kind::carried_within, error}, {}};
}

std::optional<double> carried_by_centre(const Scene &scene, Terminal &terminal)
{
  try
  {
    const DiscreteProblem problem = discretise(scene);
    SolverControls controls;
    controls.n_max_iterations = n_centre_iterations;
    const Solution solution =
        AnalyticCentre().solve(problem, controls, terminal);
    if (solution.mechanism)
      return {};
    const InterfaceForces forces = dimensional_forces(problem, solution);
    if (!is_exact(scene, certify(scene, forces)))
      return {};
    double force = 0., load = 0.;
    for (unsigned int e = 0; e < forces.normal.size(); ++e)
      force =
          std::max(force, std::hypot(forces.normal[e], forces.tangential[e]));
    for (const double size : largest_loads(scene))
      load = std::max(load, size);
    if (!(load > 0.))
      return {}; // there is nothing to compare with
    return force / load;
  }
  catch (const InputError &)
  {}
  catch (const SolverError &)
  {}
  catch (const std::bad_alloc &)
  {}
  return {}; // whoever asked has no second opinion
}
} // namespace Voussoir
