// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_factor_search_h
#define voussoir_run_factor_search_h

#include <voussoir/analyses/factors/load_factor_parameters.h>
#include <voussoir/analyses/state/solver_parameters.h>
#include <voussoir/run/scene_parameters.h>

#include <optional>

namespace Voussoir
{
/** What was found, and the scene that its forces are in equilibrium in. */
struct FactorSearch
{
  /** The factor, or the collapse. */
  LoadFactorAnswer answer;
  /** The scene at the factor; or the one that collapses. */
  Scene scene;
};

/**
 * Look for the factor that @p what asks for, on the loads or the strengths of
 * the scene that is @p data.
 *
 * @param data with its live loads.
 * @param parameters of the scene.
 * @param what the factor multiplies.
 * @param solver has the controls.
 * @param terminal sees the iterations.
 * @throws InputError, SolverError.
 */
FactorSearch search_factor(SceneData data,
                           const SceneParameters &parameters,
                           const LoadFactorParameters &what,
                           const SolverParameters &solver,
                           Terminal &terminal);
} // namespace Voussoir

#endif
