// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/capacity_analysis.h>
#include <voussoir/analyses/factor_analysis.h>
#include <voussoir/analyses/range_analysis.h>
#include <voussoir/analyses/sample_analysis.h>
#include <voussoir/analyses/settlement_analysis.h>
#include <voussoir/analyses/state_analysis.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/output/summary/ground_summary.h>
#include <voussoir/output/summary/messages.h>
#include <voussoir/output/summary/scene_summary.h>
#include <voussoir/output/summary/summary.h>
#include <voussoir/run/scene_analysis.h>

#include <utility>

namespace Voussoir
{
namespace
{
/** What else may be asked of states, in the order in which it is. */
FurtherAnalyses all_further_analyses()
{
  FurtherAnalyses further;
  further.push_back(std::make_unique<SettlementAnalysis>());
  further.push_back(std::make_unique<RangeAnalysis>());
  further.push_back(std::make_unique<SampleAnalysis>());
  return further;
}

/** The values of `Analysis`, in the order in which they are documented. */
std::vector<std::unique_ptr<Analysis>>
all_analyses(const FurtherAnalyses &further)
{
  std::vector<std::unique_ptr<Analysis>> analyses;
  analyses.push_back(std::make_unique<StateAnalysis>(further));
  analyses.push_back(std::make_unique<FactorAnalysis>());
  analyses.push_back(std::make_unique<CapacityAnalysis>());
  return analyses;
}
} // namespace

SceneAnalysis::SceneAnalysis(Terminal &terminal,
                             const ProcessGroup &processes,
                             dealii::TimerOutput &timer)
    : terminal(terminal), n_processes(processes.size()), timer(timer),
      solver(processes), further(all_further_analyses()),
      analyses(all_analyses(further))
{}

void SceneAnalysis::add_entries(dealii::ParameterHandler &prm)
{
  prm.add_parameter(
      "Forces from", earlier_directory,
      "The output directory of an earlier run of the same packing, supports, "
      "loads and strengths, of which the forces are used again: only what "
      "follows from them is computed, such as the stress by another "
      "'Accuracy'. "
      "It needs the .csv files there. 'Formulation' and 'Solver' then change "
      "nothing, but for 'Equilibrate'. It may be 'Output directory' itself. A "
      "relative path starts at the directory that the program is run in. "
      "Empty: solve.",
      dealii::Patterns::Anything());
  std::vector<Choice<unsigned int>> choices;
  for (unsigned int i = 0; i < analyses.size(); ++i)
    choices.push_back({i, analyses[i]->name(), analyses[i]->meaning(),
                       analyses[i]->sections()});
  add_choice(prm, "Analysis", chosen, choices, "What is asked of the packing.");
}

void SceneAnalysis::add_sections(dealii::ParameterHandler &prm,
                                 const NamedSections &names)
{
  solver.add_parameters(prm);
  of_scene.add_parameters(prm, names);
  for (const auto &of : analyses)
    of->add_parameters(prm);
  for (const auto &of : further)
    of->add_parameters(prm);
}

std::optional<EarlierRun> SceneAnalysis::earlier_run() const
{
  if (earlier_directory.empty())
    return {};
  if (!analysis().takes_forces())
    throw InputError("'Forces from' gives the forces of a state, and "
                     "'Analysis' is '" +
                     analysis().name() +
                     "'; set 'Analysis = state' or leave 'Forces from' empty.");
  return EarlierRun(earlier_directory);
}

SceneData SceneAnalysis::data(Packing<2> packing) const
{
  SceneData data =
      of_scene.data(std::move(packing), analysis().has_live_loads(), terminal);
  show_packing(terminal, data.packing);
  return data;
}

void SceneAnalysis::show(SceneData data, const UnitNames &units) const
{
  const Scene scene = of_scene.scene_of(data);
  show_scene(terminal, scene, units);
  show_loads(terminal, scene);
  if (analysis().has_live_loads())
    show_loads(terminal, of_scene.live_scene_of(std::move(data)), "Live loads");
  analysis().check(scene);
}

RunResult SceneAnalysis::answer(SceneData data,
                                std::optional<EarlierRun> earlier) const
{
  AnalysisContext context = {
      of_scene,
      solver,
      timer,
      terminal,
      [&](const Scene &scene) { show_loads(terminal, scene); },
      nullptr};
  if (earlier)
    context.read_forces = [&](const Scene &scene, SolverRecord &record) {
      return earlier->forces(scene, record);
    };
  AnalysisOutcome outcome = analysis().answer(std::move(data), context);
  RunRecord record(*outcome.scene, std::move(outcome.record));
  record.n_processes = n_processes;
  auto *const carried = std::get_if<Carried>(&outcome.answer);
  if (carried == nullptr)
    return {std::move(outcome.scene),
            Collapse(std::move(record),
                     std::get<NotCarried>(std::move(outcome.answer)))};
  Results results(std::move(record), std::move(*carried),
                  std::move(outcome.results));
  for (const std::string &warning : doubts_about(results))
    terminal.warning(warning);
  return {std::move(outcome.scene), std::move(results)};
}
} // namespace Voussoir
