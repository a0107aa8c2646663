// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/factor_without_dilatancy.h>
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/run/factor_search.h>

#include <utility>

namespace Voussoir
{
namespace
{
/** All loads as live ones. */
SceneData with_all_live(SceneData data)
{
  data.live_loads.add(1., data.loads);
  data.loads = no_loads(data.packing);
  return data;
}

/** The factor of strengths that all forces are proportional to. */
FactorSearch as_factor_of_loads(const SceneData &data,
                                const SceneParameters &parameters,
                                const LoadFactorControls &controls,
                                Terminal &terminal)
{
  const SceneData all = with_all_live(data);
  FactorSearch found = {find_load_factor(parameters.scene_of(all),
                                         parameters.live_scene_of(all),
                                         controls, terminal),
                        parameters.scene_at(all, 1.)};
  if (!found.answer.factor)
    return found;
  LoadFactor &factor = *found.answer.factor;
  const double divisor = factor.carried;
  if (!(divisor > 0.))
  {
    if (factor.width() > controls.tolerance)
      throw SolverError(
          text("The strength factor was not found: no forces prove one, and a "
               "mechanism only that it is at most ",
               factor.bound, ". Try a larger 'Solver/Maximum iterations'."));
    // No strengths carry the loads.
    found.answer.collapse = std::move(factor.mechanism);
    found.answer.factor.reset();
    return found;
  }
  found.scene = with_strengths_divided(found.scene, divisor);
  for (auto *const forces : {&factor.forces.normal, &factor.forces.tangential})
    for (double &force : *forces)
      force /= divisor;
  for (auto &ends : factor.forces.at_ends)
    for (double &force : ends)
      force /= divisor;
  return found;
}

FactorSearch search_strength(const SceneData &data,
                             const SceneParameters &parameters,
                             const LoadFactorControls &controls,
                             Terminal &terminal)
{
  const Scene scene = parameters.scene_at(data, 1.);
  check_strength_factor(scene, controls);
  if (scene.coefficient.empty() && !scene.has_normal_limits())
    return as_factor_of_loads(data, parameters, controls, terminal);
  FactorSearch found = {find_strength_factor(scene, controls, terminal), scene};
  if (found.answer.factor)
    found.scene = with_strengths_divided(scene, found.answer.factor->carried);
  return found;
}
} // namespace

FactorSearch search_factor(SceneData data,
                           const SceneParameters &parameters,
                           const LoadFactorParameters &what,
                           const SolverParameters &solver,
                           Terminal &terminal)
{
  const LoadFactorControls controls = what.controls(solver.controls());
  if (what.factor() == LoadFactorParameters::Factor::strength)
    return search_strength(data, parameters, controls, terminal);
  if (what.factor() == LoadFactorParameters::Factor::all_loads)
    data = with_all_live(std::move(data));
  const Scene dead = parameters.scene_of(data);
  const Scene live = parameters.live_scene_of(data);
  LoadFactorAnswer answer =
      dead.dilates ? find_load_factor(dead, live, controls, terminal)
                   : find_factor_without_dilatancy(dead, live, solver.coulomb(),
                                                   solver.controls(), controls,
                                                   terminal);
  const double factor = answer.factor ? answer.factor->carried : 0.;
  return {std::move(answer), parameters.scene_at(std::move(data), factor)};
}
} // namespace Voussoir
