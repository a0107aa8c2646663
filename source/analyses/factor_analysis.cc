// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factor_analysis.h>
#include <voussoir/analyses/factor_outcome.h>
#include <voussoir/analyses/factors/factor_without_dilatancy.h>
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>

#include <algorithm>
#include <cmath>
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
                                const LoadFactorControls &controls,
                                const AnalysisContext &context)
{
  const SceneData all = with_all_live(data);
  FactorSearch found = {find_load_factor(context.parameters.scene_of(all),
                                         context.parameters.live_scene_of(all),
                                         controls, context.terminal),
                        context.parameters.scene_at(all, 1.)};
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
                             const LoadFactorControls &controls,
                             const AnalysisContext &context)
{
  const Scene scene = context.parameters.scene_at(data, 1.);
  check_strength_factor(scene, controls);
  if (scene.coefficient.empty() && !scene.has_more_than_friction())
    return as_factor_of_loads(data, controls, context);
  FactorSearch found = {find_strength_factor(scene, controls, context.terminal),
                        scene};
  if (found.answer.factor)
    found.scene = with_strengths_divided(scene, found.answer.factor->carried);
  return found;
}

FactorSearch search_loads(SceneData data,
                          const LoadFactorControls &controls,
                          const AnalysisContext &context)
{
  const Scene dead = context.parameters.scene_of(data);
  const Scene live = context.parameters.live_scene_of(data);
  LoadFactorAnswer answer =
      dead.dilates
          ? find_load_factor(dead, live, controls, context.terminal)
          : find_factor_without_dilatancy(dead, live, context.solver.coulomb(),
                                          context.solver.controls(), controls,
                                          context.terminal);
  const double factor = answer.factor ? answer.factor->carried : 0.;
  return {std::move(answer),
          context.parameters.scene_at(std::move(data), factor),
          LiveLoads{live.load, live.load_torque}};
}

void warn_of_moving_supports(const SceneData &data,
                             const AnalysisContext &context)
{
  if (!context.parameters.motion_of_supports(data.packing).empty())
    context.terminal.warning(
        "'Supports/Displacement' has no effect on a load factor; leave it "
        "empty, or set 'Analysis = state'.");
}

/** How the forces at the factor were found. */
SolverRecord record_of(const LoadFactor &factor, const CoulombState &coulomb)
{
  SolverRecord record;
  record.formulation = "load factor";
  record.selection =
      factor.trials.empty() || factor.own_collapse
          ? "one of the states that carry the loads at the factor"
          : coulomb.selection();
  record.outcome = factor.stop.words();
  record.passes = factor.passes;
  record.n_iterations = record.n_evaluations = factor.n_iterations;
  return record;
}
} // namespace

AnalysisOutcome FactorAnalysis::answer(SceneData data,
                                       const AnalysisContext &context) const
{
  warn_of_moving_supports(data, context);
  context.timer.enter_subsection("statics");
  context.terminal.begin("Statics");
  using Factor = FactorEntries::Factor;
  const LoadFactorControls controls =
      entries.controls(context.solver.controls());
  if (entries.multiplied == Factor::all_loads)
    data = with_all_live(std::move(data));
  FactorSearch found = entries.multiplied == Factor::strength
                           ? search_strength(data, controls, context)
                           : search_loads(std::move(data), controls, context);
  context.timer.leave_subsection();
  SolverRecord record;
  if (found.answer.factor)
    record = record_of(*found.answer.factor, context.solver.coulomb());
  const std::string stage = text("load factor: ", record.outcome, " after ",
                                 counted(record.n_iterations, "iteration"));
  AnalysisOutcome outcome = outcome_of(
      found, record, stage, entries.multiplied == Factor::live_loads, context);
  if (!found.answer.factor)
    return outcome;
  const LoadFactor &factor = *found.answer.factor;
  AnalysisResult result = {
      "load_factor",   "Load factor", description_of(factor),
      json_of(factor), true,          sentence_of(factor, entries.multiplied)};
  result.motion = mechanism_of(found);
  outcome.results.push_back(std::move(result));
  return outcome;
}
} // namespace Voussoir
