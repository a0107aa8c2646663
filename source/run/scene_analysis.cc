// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/output/csv.h>
#include <voussoir/output/summary/ground_summary.h>
#include <voussoir/output/summary/messages.h>
#include <voussoir/output/summary/scene_summary.h>
#include <voussoir/output/summary/summary.h>
#include <voussoir/run/factor_search.h>
#include <voussoir/run/scene_analysis.h>
#include <voussoir/statics/problem/discretise.h>
#include <voussoir/stress/cell_means.h>

#include <utility>

namespace Voussoir
{
SceneAnalysis::SceneAnalysis(Terminal &terminal,
                             const ProcessGroup &processes,
                             dealii::TimerOutput &timer)
    : terminal(terminal), n_processes(processes.size()), timer(timer),
      solver(processes)
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
  add_choice<Analysis>(
      prm, "Analysis", analysis,
      {{Analysis::state, "state",
        "forces that carry the loads, or the mechanism in which the packing "
        "collapses.",
        "Ranges"},
       {Analysis::load_factor, "load factor",
        "the greatest factor of the live loads that is carried, or the least, "
        "between two proofs: forces that balance the loads at it, and a "
        "mechanism that bounds it.",
        "Live loads, Load factor"}},
      "What is asked of the packing.");
}

void SceneAnalysis::add_sections(dealii::ParameterHandler &prm,
                                 const std::set<std::string> &load_cases)
{
  solver.add_parameters(prm);
  of_scene.add_parameters(prm, load_cases);
  load_factor.add_parameters(prm);
  ranges.add_parameters(prm);
}

std::optional<EarlierRun> SceneAnalysis::earlier_run() const
{
  if (earlier_directory.empty())
    return {};
  if (analysis == Analysis::load_factor)
    throw InputError("'Forces from' gives the forces of a state, and "
                     "'Analysis' is 'load factor'; set 'Analysis = state' or "
                     "leave 'Forces from' empty.");
  return EarlierRun(earlier_directory);
}

SceneData SceneAnalysis::data(Packing packing) const
{
  SceneData data = of_scene.data(std::move(packing),
                                 analysis == Analysis::load_factor, terminal);
  show_packing(terminal, data.packing);
  return data;
}

void SceneAnalysis::show(SceneData data, const UnitNames &units) const
{
  const Scene scene = of_scene.scene_of(data);
  show_scene(terminal, scene, units);
  show_loads(terminal, scene);
  if (analysis == Analysis::load_factor)
    show_loads(terminal, of_scene.live_scene_of(std::move(data)), "Live loads");
  if (analysis == Analysis::state && ranges.samples())
    check_can_be_sampled(scene);
}

RunResult SceneAnalysis::answer(SceneData data,
                                std::optional<EarlierRun> earlier)
{
  RunResult findings = find(std::move(data), std::move(earlier));
  if (const auto *const carried = std::get_if<Results>(&findings.found))
    for (const std::string &warning : doubts_about(*carried))
      terminal.warning(warning);
  return findings;
}

RunResult SceneAnalysis::find(SceneData data, std::optional<EarlierRun> earlier)
{
  if (analysis == Analysis::state)
    return find_state(std::move(data), std::move(earlier));
  if (!of_scene.motion_of_supports(data.packing).empty())
    terminal.warning("'Supports/Displacement' has no effect on a load factor; "
                     "leave it empty, or set 'Analysis = state'.");
  return find_factor(std::move(data));
}

RunResult SceneAnalysis::find_state(SceneData data,
                                    std::optional<EarlierRun> earlier)
{
  auto owned =
      std::make_unique<const Scene>(of_scene.scene_of(std::move(data)));
  const Scene &scene = *owned;
  if (ranges.samples())
    check_can_be_sampled(scene);
  show_loads(terminal, scene);
  RunRecord record = record_of(scene);
  Answer answer =
      earlier ? judge(scene, read_forces(*earlier, scene, record), record,
                      solver.controls().tolerance, timer, terminal)
              : analyse(scene, solver.formulation_for(scene), solver.controls(),
                        record, timer, terminal);
  std::optional<Settlement> settlement = settlement_of(answer, scene, record);
  auto *const carried = std::get_if<Carried>(&answer);
  if (carried == nullptr)
    return {std::move(owned),
            Collapse(record, std::get<NotCarried>(std::move(answer)))};
  Results results(record, std::move(*carried));
  results.settlement = std::move(settlement);
  results.ranges = ranges_of(scene);
  results.samples = samples_of(scene);
  return {std::move(owned), std::move(results)};
}

RunRecord SceneAnalysis::record_of(const Scene &scene) const
{
  RunRecord record(scene);
  record.n_processes = n_processes;
  return record;
}

std::optional<Settlement> SceneAnalysis::settlement_of(Answer &answer,
                                                       const Scene &scene,
                                                       SolverRecord &record)
{
  const std::vector<SupportMotion> of_supports =
      of_scene.motion_of_supports(scene.packing);
  if (of_supports.empty() || std::holds_alternative<NotCarried>(answer))
    return {};
  timer.enter_subsection("settlement");
  terminal.begin("Settlement");
  Settlement found = find_settlement(scene, of_supports);
  record.formulation = "settlement";
  record.selection = "forces that go with the displacement of the supports";
  record.outcome = Stop(Stop::Reason::converged).words();
  record.passes = {};
  record.n_iterations = record.n_evaluations = found.n_iterations;
  terminal.stage("Settlement", counted(record.n_iterations, "step") +
                                   " of the simplex method");
  timer.leave_subsection();
  Carried state;
  state.forces = std::move(found.forces);
  state.motion = found.motion;
  answer = judge(scene, std::move(state), record, solver.controls().tolerance,
                 timer, terminal);
  return found;
}

std::optional<Ranges> SceneAnalysis::ranges_of(const Scene &scene)
{
  const std::optional<RangesWanted> wanted = ranges.wanted(scene.packing);
  if (!wanted)
    return {};
  const dealii::TimerOutput::Scope section(timer, "ranges");
  terminal.begin("Ranges");
  Ranges found = find_ranges(scene, *wanted, terminal);
  terminal.stage("Ranges",
                 text(counted(found.proofs.n_programmes, "linear programme"),
                      ", ", counted(found.proofs.n_iterations, "step")));
  return found;
}

std::optional<StateSamples> SceneAnalysis::samples_of(const Scene &scene)
{
  const std::optional<SamplesWanted> wanted = ranges.samples();
  if (!wanted)
    return {};
  const dealii::TimerOutput::Scope section(timer, "samples");
  terminal.begin("Samples");
  StateSamples drawn = draw_samples(scene, *wanted, terminal);
  terminal.stage("Samples",
                 text(counted(drawn.n, "state"), ", ",
                      counted(drawn.n_steps, "step"), " from one to the next"));
  return drawn;
}

RunResult SceneAnalysis::find_factor(SceneData data)
{
  timer.enter_subsection("statics");
  terminal.begin("Statics");
  FactorSearch search =
      search_factor(std::move(data), of_scene, load_factor, solver, terminal);
  timer.leave_subsection();
  auto owned = std::make_unique<const Scene>(std::move(search.scene));
  const Scene &scene = *owned;
  show_loads(terminal, scene);
  RunRecord record = record_of(scene);
  if (!search.answer.factor)
  {
    Collapse collapse(record, prove(scene, std::move(search.answer.collapse)));
    collapse.of_dead_loads =
        load_factor.factor() == LoadFactorParameters::Factor::live_loads;
    return {std::move(owned), std::move(collapse)};
  }

  LoadFactor &factor = *search.answer.factor;
  record.formulation = "load factor";
  record.selection =
      factor.trials.empty()
          ? "one of the states that carry the loads at the factor"
          : solver.coulomb().selection();
  record.outcome = factor.stop.words();
  record.passes = factor.passes;
  record.n_iterations = record.n_evaluations = factor.n_iterations;
  terminal.stage("Statics", text("load factor: ", record.outcome, " after ",
                                 counted(record.n_iterations, "iteration")));
  Carried found;
  found.forces = std::move(factor.forces);
  found.motion = Motion(scene.packing.n_cells(), *scene.kinematics);
  Answer state = judge(scene, std::move(found), record,
                       solver.controls().tolerance, timer, terminal);
  auto *const carried = std::get_if<Carried>(&state);
  if (!carried)
    throw SolverError("The state found at the load factor does not carry its "
                      "loads; loosen 'Solver/Tolerance of the load factor'.");
  Results results(record, std::move(*carried));
  results.load_factor = std::move(factor);
  return {std::move(owned), std::move(results)};
}

Carried SceneAnalysis::read_forces(EarlierRun &earlier,
                                   const Scene &scene,
                                   SolverRecord &record)
{
  timer.enter_subsection("statics");
  terminal.begin("Statics");
  Carried found = earlier.forces(scene, record);
  if (solver.controls().equilibrate && !found.correction)
  {
    const DiscreteProblem problem = discretise(scene);
    Solution solution;
    solution.forces = nondimensional_forces(problem, found.forces);
    equilibrate_solution(problem, solution);
    found.forces = dimensional_forces(problem, solution);
    found.correction = solution.correction;
  }
  terminal.stage("Statics", text(record.formulation, ": ", record.outcome));
  timer.leave_subsection();
  return found;
}
} // namespace Voussoir
