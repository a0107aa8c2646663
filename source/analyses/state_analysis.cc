// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/state_analysis.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/problem/discretise.h>

#include <boost/algorithm/string/join.hpp>

#include <set>
#include <utility>

namespace Voussoir
{
namespace
{
/** The forces that are read, balanced to rounding if that is asked for. */
Carried read_state(const Scene &scene,
                   SolverRecord &record,
                   const AnalysisContext &context)
{
  const dealii::TimerOutput::Scope section(context.timer, "statics");
  context.terminal.begin("Statics");
  Carried found = context.read_forces(scene, record);
  if (context.solver.controls().equilibrate && !found.correction)
  {
    const DiscreteProblem problem = discretise(scene);
    Solution solution;
    solution.forces = nondimensional_forces(problem, found.forces);
    equilibrate_solution(problem, solution);
    found.forces = dimensional_forces(problem, solution);
    found.correction = solution.correction;
  }
  context.terminal.stage("Statics",
                         text(record.formulation, ": ", record.outcome));
  return found;
}

Answer find_state(const Scene &scene,
                  SolverRecord &record,
                  const AnalysisContext &context)
{
  const SolverControls &controls = context.solver.controls();
  if (context.read_forces)
    return judge(scene, read_state(scene, record, context), record,
                 controls.tolerance, context.timer, context.terminal);
  return analyse(scene, context.solver.formulation_for(scene), controls, record,
                 context.timer, context.terminal);
}
} // namespace

std::string StateAnalysis::sections() const
{
  std::set<std::string> names;
  for (const auto &analysis : further)
    names.insert(analysis->section());
  names.erase("");
  return boost::algorithm::join(names, ", ");
}

void StateAnalysis::check(const Scene &scene) const
{
  for (const auto &analysis : further)
    analysis->check(scene);
}

AnalysisOutcome StateAnalysis::answer(SceneData data,
                                      const AnalysisContext &context) const
{
  AnalysisOutcome outcome;
  outcome.scene = std::make_unique<const Scene>(
      context.parameters.scene_of(std::move(data)));
  check(*outcome.scene);
  context.show_loads(*outcome.scene);
  outcome.answer = find_state(*outcome.scene, outcome.record, context);
  for (const auto &analysis : further)
    if (std::holds_alternative<Carried>(outcome.answer))
      analysis->answer(outcome, context);
  return outcome;
}
} // namespace Voussoir
