// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/decide_by_factor.h>
#include <voussoir/statics/formulation.h>
#include <voussoir/statics/load_factor.h>

#include <utility>

namespace Voussoir
{
namespace
{
/** That of the two bounds, between which nothing is decided. */
constexpr double distance_of_bounds = 1e-10;

/** The scene without its loads. */
Scene without_loads(const Scene &scene)
{
  Loads none;
  none.traction.resize(scene.packing.boundary_edges().size());
  Scene bare(scene.packing, scene.strength, none, *scene.kinematics);
  bare.coefficient = scene.coefficient;
  bare.dilates = scene.dilates;
  bare.tensile_strength = scene.tensile_strength;
  bare.compressive_strength = scene.compressive_strength;
  bare.friction = scene.friction;
  return bare;
}
} // namespace

std::optional<Solution> decide_by_factor(const Scene &scene,
                                         const DiscreteProblem &problem,
                                         const unsigned int n_max_iterations,
                                         Terminal &terminal)
{
  LoadFactorControls controls;
  controls.tolerance = distance_of_bounds;
  controls.n_max_iterations = n_max_iterations;
  LoadFactor found;
  try
  {
    found = *find_load_factor(without_loads(scene), scene, controls, terminal)
                 .factor;
  }
  catch (const SolverError &)
  {
    return {};
  }
  Solution solution;
  solution.n_iterations = solution.n_evaluations = found.n_iterations;
  if (found.carried >= 1.)
  {
    solution.stop = Stop::Reason::converged;
    solution.forces = nondimensional_forces(problem, found.forces);
    for (double &force : solution.forces)
      force /= found.carried;
    solution.motion = Motion(problem.n_cells(), problem.kinematics());
    return solution;
  }
  if (!found.has_mechanism() || found.bound >= 1.)
    return {};
  solution.stop = Stop::Reason::collapse;
  solution.mechanism = Mechanism{std::move(found.mechanism), 1., found.bound};
  return solution;
}
} // namespace Voussoir
