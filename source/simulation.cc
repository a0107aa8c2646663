// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/output/blocks_vtu.h>
#include <voussoir/output/csv.h>
#include <voussoir/output/interfaces_vtu.h>
#include <voussoir/output/messages.h>
#include <voussoir/output/packing_files.h>
#include <voussoir/output/pvd.h>
#include <voussoir/output/result_directory.h>
#include <voussoir/output/stress_pieces.h>
#include <voussoir/output/stress_vtu.h>
#include <voussoir/output/summary.h>
#include <voussoir/simulation.h>
#include <voussoir/stress/cell_means.h>
#include <voussoir/unused_settings.h>

#include <boost/algorithm/string/join.hpp>

#include <cmath>
#include <iostream>
#include <optional>
#include <system_error>
#include <utility>

namespace Voussoir
{
namespace
{
const std::string parameters_prm = "parameters.prm";

/** Every file that any run may write. */
FilesOfRuns all_files()
{
  return {{interfaces_csv, cells_csv, blocks_vtu, interfaces_vtu, stress_vtu,
           stress_pvtu, mechanism_csv, mechanism_joints_csv, mechanism_vtu,
           results_pvd, parameters_prm, summary_json},
          {packing_wkt, packing_off, packing_centres},
          is_stress_piece};
}

/** The motion of the blocks beside the forces, if there is one. */
const Motion *motion_to_show(const Results &results)
{
  if (results.settlement)
    return &results.settlement->motion;
  return results.load_factor && results.load_factor->has_mechanism()
             ? &results.load_factor->mechanism
             : nullptr;
}

/** What the largest displacement of a mechanism, one, is drawn as: a cell. */
double size_of_mechanism(const Scene &scene)
{
  return std::sqrt(scene.packing.area() / scene.packing.n_cells());
}

/** Write a collection of @p grids, which ParaView opens as one file. */
void write_collection(ResultDirectory &files,
                      const std::vector<std::string> &grids)
{
  files.write(results_pvd, [&](std::ostream &out) { write_pvd(out, grids); });
}
} // namespace

Simulation::Simulation(Terminal &terminal, const Team &team)
    : terminal(terminal), team(team), timer(std::cout,
                                            dealii::TimerOutput::never,
                                            dealii::TimerOutput::wall_times),
      solver(team)
{}

void Simulation::add_parameters(dealii::ParameterHandler &prm)
{
  using dealii::Patterns::Anything;
  prm.add_parameter("Title", title, "A title for the results.", Anything());
  prm.add_parameter("Output directory", output_directory,
                    "Where the results go; created if need be. A relative path "
                    "starts at the directory that the program is run in.",
                    Anything());
  prm.add_parameter(
      "Forces from", forces_from,
      "The output directory of an earlier run of the same packing, supports, "
      "loads and strengths, of which the forces are used again: only what "
      "follows from them is computed, such as the stress by another "
      "'Accuracy'. "
      "It needs the .csv files there. 'Formulation' and 'Solver' then change "
      "nothing, but for 'Equilibrate'. It may be 'Output directory' itself. A "
      "relative path starts at the directory that the program is run in. "
      "Empty: solve.",
      Anything());
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
  solver.add_parameters(prm);
  of_scene.add_parameters(prm);
  load_factor.add_parameters(prm);
  ranges.add_parameters(prm);
  stress.add_parameters(prm);
  add_output_parameters(prm);
}

void Simulation::add_output_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Output");
  prm.add_parameter(
      "Verbosity", verbosity,
      "0: the closing summary alone; 1: also the stages and, on a "
      "screen, the progress of long ones; 2: also the iterations "
      "of the solver.",
      dealii::Patterns::Integer(0, 2));
  add_choice<ResultFiles>(
      prm, "Files", result_files,
      {{ResultFiles::all, "all", "both kinds."},
       {ResultFiles::csv, "csv",
        interfaces_csv + " and " + cells_csv + ", or those of the mechanism."},
       {ResultFiles::vtu, "vtu",
        blocks_vtu + ", " + interfaces_vtu +
            " and, unless 'Accuracy = draft', " + stress_vtu +
            ", or that of the mechanism; and " + results_pvd + "."},
       {ResultFiles::none, "none", "neither."}},
      "Which results are written besides " + summary_json + " and " +
          parameters_prm +
          ". A stress that is not written is not reconstructed.");
  add_choice<PackingFile>(
      prm, "Packing", packing_file,
      {{PackingFile::none, "none", "nothing."},
       {PackingFile::wkt, "WKT",
        packing_wkt + ", one POLYGON a line with the name of its group."},
       {PackingFile::off, "OFF", packing_off + ", without names."}},
      "What to write for another program, or to be edited and read again by "
      "the generator 'polygons': the cells, and with them their centres in " +
          packing_centres + ".");
  prm.leave_subsection();
}

void Simulation::run(const dealii::ParameterHandler &prm,
                     const std::filesystem::path &directory)
{
  terminal.set_verbosity(verbosity);
  for (const std::string &warning : unused_settings(prm))
    terminal.warning(warning);
  ResultDirectory files(output_directory, all_files(), terminal);
  for (const std::filesystem::path &file : of_scene.input_files(directory))
    files.spare(file);
  std::optional<EarlierRun> earlier;
  if (!forces_from.empty() && analysis == Analysis::load_factor)
    throw InputError("'Forces from' gives the forces of a state, and "
                     "'Analysis' is 'load factor'; set 'Analysis = state' or "
                     "leave 'Forces from' empty.");
  if (!forces_from.empty())
    earlier.emplace(forces_from);

  if (team.size() > 1)
    terminal.stage("Processes", std::to_string(team.size()));
  timer.enter_subsection("packing");
  terminal.begin("Packing");
  const bool is_state = analysis == Analysis::state;
  Given given = of_scene.read(directory, !is_state, terminal);
  show_packing(terminal, given.packing);
  if (!is_state)
  {
    if (!of_scene.motion_of_supports(given.packing).empty())
      terminal.warning(
          "'Supports/Displacement' has no effect on a load factor; "
          "leave it empty, or set 'Analysis = state'.");
    timer.leave_subsection();
    return find_factor(files, std::move(given), prm);
  }
  const Scene scene = of_scene.scene_of(std::move(given));
  timer.leave_subsection();
  RunRecord record = record_of(scene);
  Answer answer =
      earlier ? judge(scene, read_forces(*earlier, scene, record), record,
                      solver.controls().tolerance, timer, terminal)
              : analyse(scene, solver.formulation_for(scene), solver.controls(),
                        record, timer, terminal);
  std::optional<Settlement> settlement = settle(answer, scene, record);
  auto *const carried = std::get_if<Carried>(&answer);
  if (carried == nullptr)
    write(files, Collapse(record, std::get<NotCarried>(std::move(answer))),
          prm);
  Results results(record, std::move(*carried));
  results.settlement = std::move(settlement);
  results.ranges = ranges_of(scene);
  results.samples = samples_of(scene);
  write(files, std::move(results), prm);
}

RunRecord Simulation::record_of(const Scene &scene) const
{
  RunRecord record(scene);
  record.title = title;
  record.n_processes = team.size();
  return record;
}

std::optional<Settlement>
Simulation::settle(Answer &answer, const Scene &scene, SolverRecord &record)
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

std::optional<Ranges> Simulation::ranges_of(const Scene &scene)
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

std::optional<StateSamples> Simulation::samples_of(const Scene &scene)
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

void Simulation::find_factor(ResultDirectory &files,
                             Given given,
                             const dealii::ParameterHandler &prm)
{
  timer.enter_subsection("statics");
  terminal.begin("Statics");
  FactorSearch search =
      search_factor(std::move(given), of_scene, load_factor, solver, terminal);
  timer.leave_subsection();
  const Scene &scene = search.scene;
  RunRecord record = record_of(scene);
  if (!search.answer.factor)
    write(files,
          Collapse(record, prove(scene, std::move(search.answer.collapse))),
          prm);

  LoadFactor &factor = *search.answer.factor;
  record.formulation = "load factor";
  record.selection = "one of the states that carry the loads at the factor";
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
  write(files, std::move(results), prm);
}

Carried Simulation::read_forces(EarlierRun &earlier,
                                const Scene &scene,
                                SolverRecord &record)
{
  timer.enter_subsection("statics");
  terminal.begin("Statics");
  Carried found = earlier.forces(scene, record);
  if (solver.controls().equilibrate && !found.correction)
  {
    const DiscreteProblem problem(scene);
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

bool Simulation::writes(const ResultFiles kind) const
{
  // Forces from the directory of the results are not lost there, whatever
  // 'Files' says: publish() removes what is not written.
  std::error_code not_there;
  const bool keeps_forces =
      kind == ResultFiles::csv && !forces_from.empty() &&
      std::filesystem::equivalent(forces_from, output_directory, not_there);
  return result_files == ResultFiles::all || result_files == kind ||
         keeps_forces;
}

void Simulation::write(ResultDirectory &files,
                       Results results,
                       const dealii::ParameterHandler &prm)
{
  for (const std::string &warning : doubts_about(results))
    terminal.warning(warning);

  timer.enter_subsection("stress");
  terminal.begin("Stress");
  const std::optional<StressPart> own_part = find_stresses(results);
  timer.leave_subsection();

  timer.enter_subsection("output");
  terminal.begin("Output");
  const Motion *motion = motion_to_show(results);
  const auto add = [&](const std::string &name, const auto &writer) {
    files.write(name, [&](std::ostream &out) { writer(out, results); });
  };
  if (writes(ResultFiles::csv))
  {
    add(interfaces_csv, write_interfaces_csv);
    add(cells_csv, write_cells_csv);
  }
  if (writes(ResultFiles::vtu))
  {
    // In the order of display, later grids over earlier ones.
    std::vector<std::string> grids = {blocks_vtu, interfaces_vtu};
    add(blocks_vtu, write_blocks_vtu);
    if (stress.reconstruct())
      grids.insert(grids.begin() + 1, write_stress(files, results, own_part));
    add(interfaces_vtu, write_interfaces_vtu);
    if (motion)
      grids.push_back(mechanism_vtu);
    write_collection(files, grids);
  }
  if (motion)
    write_mechanism(files, results.scene, *motion,
                    results.settlement ? 1. : size_of_mechanism(results.scene));
  publish(files, results, prm);
  show_summary(terminal, results);
}

std::optional<StressPart> Simulation::find_stresses(Results &results)
{
  const Scene &scene = results.scene;
  results.reactions = reactions(scene, results.forces);
  if (writes(ResultFiles::csv) || writes(ResultFiles::vtu))
  {
    results.torques = residual_torques(scene, results.forces);
    results.mean_stresses = cell_mean_stresses(scene, results.forces);
  }
  std::optional<StressPart> own_part;
  if (!stress.reconstruct() || !writes(ResultFiles::vtu))
    return own_part;

  const Reconstruction how = stress.reconstruction();
  if (team.size() == 1)
    results.stress = reconstruct_stress(scene, results.forces, how, terminal);
  else
  {
    own_part.emplace(reconstruct_on_root(scene, results.forces, results.motion,
                                         how, team, terminal));
    results.stress.n_sub_cells = own_part->stress.n_sub_cells;
    results.stress.undetermined = own_part->stress.undetermined;
  }
  terminal.stage("Stress", text(results.stress.n_sub_cells, " sub-cells"));
  for (const std::string &warning : undetermined_cells(scene, results.stress))
    terminal.warning(warning);
  return own_part;
}

std::string
Simulation::write_stress(ResultDirectory &files,
                         const Results &results,
                         const std::optional<StressPart> &own_part) const
{
  if (own_part)
  {
    write_stress_pieces(files, *own_part, team);
    return stress_pvtu;
  }
  files.write(stress_vtu, [&](std::ostream &out) {
    write_stress_vtu(out,
                     {results.scene.packing, results.stress, results.motion});
  });
  return stress_vtu;
}

void Simulation::write(ResultDirectory &files,
                       Collapse collapse,
                       const dealii::ParameterHandler &prm)
{
  timer.enter_subsection("output");
  terminal.begin("Output");
  write_mechanism(files, collapse.scene, collapse.motion,
                  size_of_mechanism(collapse.scene));
  std::vector<std::string> to_look_at;
  if (writes(ResultFiles::vtu))
  {
    write_collection(files, {mechanism_vtu});
    to_look_at.push_back(results_pvd);
  }
  if (writes(ResultFiles::csv))
    to_look_at.push_back(mechanism_joints_csv);
  publish(files, collapse, prm);
  terminal.status(Status{Status::Kind::collapse, 0.}.word(), false);
  throw LoadNotCarried(
      message_of(collapse, boost::algorithm::join(to_look_at, " and ")));
}

void Simulation::write_mechanism(ResultDirectory &files,
                                 const Scene &scene,
                                 const Motion &motion,
                                 const double factor) const
{
  const auto add = [&](const std::string &name, const auto &writer) {
    files.write(name, [&](std::ostream &out) { writer(out, scene, motion); });
  };
  if (writes(ResultFiles::vtu))
    files.write(mechanism_vtu, [&](std::ostream &out) {
      write_mechanism_vtu(out, scene.packing, motion, factor);
    });
  if (writes(ResultFiles::csv))
  {
    add(mechanism_csv, write_mechanism_csv);
    add(mechanism_joints_csv, write_mechanism_joints_csv);
  }
}

template <typename Found>
void Simulation::publish(ResultDirectory &files,
                         Found &found,
                         const dealii::ParameterHandler &prm)
{
  const auto add = [&](const std::string &name, const auto &writer) {
    files.write(name,
                [&](std::ostream &out) { writer(out, found.scene.packing); });
  };
  if (packing_file == PackingFile::wkt)
    add(packing_wkt, write_packing_wkt);
  if (packing_file == PackingFile::off)
    add(packing_off, write_packing_off);
  if (packing_file != PackingFile::none)
    add(packing_centres, write_centres);
  files.write(parameters_prm, [&](std::ostream &out) {
    using Style = dealii::ParameterHandler;
    prm.print_parameters(out, Style::ShortPRM | Style::KeepDeclarationOrder);
  });
  timer.leave_subsection();
  found.timings = timer.get_summary_data(dealii::TimerOutput::total_wall_time);
  files.write(summary_json, [&](std::ostream &out) {
    write_summary_json(out, found); // last: it marks a complete set
  });
  files.publish();
  terminal.stage("Output",
                 "written to " + output_directory +
                     (writes(ResultFiles::vtu)
                          ? "; " + results_pvd + " opens all of it in ParaView"
                          : ""));
}
} // namespace Voussoir
