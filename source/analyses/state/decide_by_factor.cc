// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/analyses/state/decide_by_factor.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/problem/discretise.h>
#include <voussoir/statics/problem/formulation.h>

#include <utility>

namespace Voussoir
{
namespace
{
/** The distance of the two bounds, between which nothing is decided. */
constexpr double distance_of_bounds = 1e-10;

/** What find_load_factor() finds, if anything. */
std::optional<LoadFactor> factor_of_all_loads(const Scene &scene,
                                              const unsigned int n_iterations,
                                              Terminal &terminal)
{
  Scene bare = scene;
  bare.load.assign(scene.load.size(), {});
  bare.load_size.assign(scene.load_size.size(), 0.);
  bare.load_torque.assign(scene.load_torque.size(), 0.);
  LoadFactorControls controls;
  controls.tolerance = distance_of_bounds;
  controls.n_max_iterations = n_iterations;
  try
  {
    return find_load_factor(bare, scene, controls, terminal).factor;
  }
  catch (const SolverError &)
  {
    return {};
  }
}

bool carry(const Scene &scene, const InterfaceForces &forces)
{
  return certify(scene, forces).error() <= largest_accepted_error;
}
} // namespace

std::optional<Solution> decide_by_factor(const Scene &scene,
                                         const DiscreteProblem &problem,
                                         const unsigned int n_max_iterations,
                                         Terminal &terminal)
{
  std::optional<LoadFactor> found =
      factor_of_all_loads(scene, n_max_iterations, terminal);
  if (!found)
    return {};
  Solution solution;
  solution.n_iterations = solution.n_evaluations = found->n_iterations;
  if (found->is_unbounded || found->carried >= 1.)
  {
    solution.stop = Stop::Reason::converged;
    solution.forces = nondimensional_forces(problem, found->forces);
    for (double &force : solution.forces)
      force /= found->carried;
    if (!carry(scene, dimensional_forces(problem, solution)))
      return {};
    return solution;
  }
  if (!found->has_mechanism() ||
      !proves_collapse(certify_mechanism(scene, found->mechanism)))
    return {};
  solution.stop = Stop::Reason::collapse;
  solution.mechanism = Mechanism{
      nondimensional_motion(problem, found->mechanism, 1.), 1., found->bound};
  return solution;
}
} // namespace Voussoir
