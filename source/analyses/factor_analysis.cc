// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factor_analysis.h>
#include <voussoir/analyses/factors/factor_without_dilatancy.h>
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** Up to which of the factors that were tried there are states. */
std::string states_that_end(const FactorTrials &trials)
{
  const double without = trials.without_state.front();
  const auto beyond =
      std::find_if(trials.with_state.begin(), trials.with_state.end(),
                   [without](const double factor) {
                     return std::abs(factor) > std::abs(without);
                   });
  return beyond == trials.with_state.begin()
             ? text("but ", text_to_copy(without), " has no state")
             : text("but states are known up to ",
                    text_to_copy(*std::prev(beyond)), " only, and ",
                    text_to_copy(without), " has none");
}

/** What the factors that were tried say of each other. */
std::string description_without_dilatancy(const LoadFactor &factor)
{
  const auto smaller = [&](const double tried) {
    return std::abs(tried) < std::abs(factor.carried);
  };
  const FactorTrials &trials = factor.trials;
  const unsigned int n_with = std::count_if(trials.with_state.begin(),
                                            trials.with_state.end(), smaller);
  const unsigned int n_without = std::count_if(
      trials.without_state.begin(), trials.without_state.end(), smaller);
  std::string words = text_to_copy(factor.carried);
  if (factor.own_collapse)
    words += text(
        " is a collapse without dilatancy, by its own forces and mechanism, ",
        n_without > 0
            ? states_that_end(trials)
            : text("and the ", n_with, " smaller factors tried have states"));
  else if (n_without > 0)
    words +=
        text(" has a state without dilatancy, but of ", n_with + n_without,
             " smaller factors tried ", n_without,
             n_without > 1 ? " have none, the least of them " : " has none, ",
             text_to_copy(trials.without_state.front()));
  else
    words += text(
        " has a state without dilatancy, ",
        n_with > 1 ? text("and so have the ", n_with, " smaller factors tried")
        : n_with == 1 ? "and so has the one smaller factor tried"
                      : "the only factor tried that has one");
  words += "; of others nothing is known, since no theorem holds";
  return std::isfinite(factor.bound)
             ? text(words, "; ", text_to_copy(factor.bound),
                    " collapses, with it or without, which is proven")
             : words + "; no mechanism was found that bounds it";
}

/** The load factor between its proofs. */
Json summary_of(const LoadFactor &factor)
{
  Json json = json_of_proofs(factor);
  if (factor.own_collapse)
    json["own_collapse"] = {
        {"factor", factor.own_collapse->factor},
        {"closing_violation", factor.own_collapse->closing_violation}};
  if (!factor.trials.empty())
    json["tried"] = {{"with_state", factor.trials.with_state},
                     {"without_state", factor.trials.without_state}};
  json["meaning"] = description_of(factor);
  return json;
}

/** What was found, and the scene that its forces are in equilibrium in. */
struct FactorSearch
{
  /** The factor, or the collapse. */
  LoadFactorAnswer answer;
  /** The scene at the factor; or the one that collapses. */
  Scene scene;
};

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
  if (scene.coefficient.empty() && !scene.has_normal_limits())
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
          context.parameters.scene_at(std::move(data), factor)};
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

/** The forces at the factor, which cells do not move under. */
Carried state_at(LoadFactor &factor, const Scene &scene)
{
  Carried state;
  state.forces = std::move(factor.forces);
  state.motion = Motion(scene.packing.n_cells(), *scene.kinematics);
  return state;
}
} // namespace

std::string description_of(const LoadFactor &factor)
{
  if (!factor.trials.empty())
    return description_without_dilatancy(factor);
  return words_of_proofs(factor);
}

AnalysisOutcome FactorAnalysis::answer(SceneData data,
                                       const AnalysisContext &context) const
{
  if (!context.parameters.motion_of_supports(data.packing).empty())
    context.terminal.warning(
        "'Supports/Displacement' has no effect on a load factor; leave it "
        "empty, or set 'Analysis = state'.");
  context.timer.enter_subsection("statics");
  context.terminal.begin("Statics");
  using Factor = FactorEntries::Factor;
  const SolverControls &common = context.solver.controls();
  const LoadFactorControls controls = entries.controls(common);
  if (entries.multiplied == Factor::all_loads)
    data = with_all_live(std::move(data));
  FactorSearch found = entries.multiplied == Factor::strength
                           ? search_strength(data, controls, context)
                           : search_loads(std::move(data), controls, context);
  context.timer.leave_subsection();
  AnalysisOutcome outcome;
  outcome.scene = std::make_unique<const Scene>(std::move(found.scene));
  const Scene &scene = *outcome.scene;
  context.show_loads(scene);
  if (!found.answer.factor)
  {
    NotCarried collapse = prove(scene, std::move(found.answer.collapse));
    if (entries.multiplied == Factor::live_loads)
      collapse.loads = found.answer.collapses_with_any
                           ? NotCarried::Loads::dead_beside_any
                           : NotCarried::Loads::dead;
    outcome.answer = std::move(collapse);
    return outcome;
  }

  LoadFactor &factor = *found.answer.factor;
  SolverRecord &record = outcome.record;
  record = record_of(factor, context.solver.coulomb());
  context.terminal.stage("Statics",
                         text("load factor: ", record.outcome, " after ",
                              counted(record.n_iterations, "iteration")));
  outcome.answer = judge(scene, state_at(factor, scene), record,
                         common.tolerance, context.timer, context.terminal);
  if (!std::holds_alternative<Carried>(outcome.answer))
    throw SolverError("The state found at the load factor does not carry its "
                      "loads; loosen 'Solver/Tolerance of the load factor'.");
  AnalysisResult result = {"load_factor", "Load factor", description_of(factor),
                           summary_of(factor), true};
  if (factor.has_mechanism())
    result.motion = MotionBeside{std::move(factor.mechanism), "Mechanism"};
  outcome.results.push_back(std::move(result));
  return outcome;
}
} // namespace Voussoir
