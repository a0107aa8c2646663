// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/output/csv.h>
#include <voussoir/output/polyhedra_csv.h>
#include <voussoir/output/report/packing_report.h>
#include <voussoir/output/report/report.h>
#include <voussoir/output/summary/messages.h>
#include <voussoir/output/summary/packing_summary.h>
#include <voussoir/output/summary/space_ground_summary.h>
#include <voussoir/output/summary/space_stress_summary.h>
#include <voussoir/output/summary/summary.h>
#include <voussoir/output/vtu/blocks_vtu.h>
#include <voussoir/output/vtu/defects_vtu.h>
#include <voussoir/output/vtu/interfaces_vtu.h>
#include <voussoir/output/vtu/packing_files.h>
#include <voussoir/output/vtu/polyhedra_vtu.h>
#include <voussoir/output/vtu/pvd.h>
#include <voussoir/output/vtu/stress_vtu.h>
#include <voussoir/output/vtu/tetrahedra_vtu.h>
#include <voussoir/packing/polyhedra/cell_overlaps.h>
#include <voussoir/packing/polyhedra/models/writers.h>
#include <voussoir/run/space_run.h>
#include <voussoir/stress/shared_tetrahedra.h>

#include <optional>
#include <ostream>
#include <utility>

namespace Voussoir
{
namespace
{
/** The factors by which a tolerance is changed, to see whether it matters. */
constexpr double smaller_tolerance = 0.1, larger_tolerance = 10.;

/** Warn of blocks of a file that penetrate each other; these as defects. */
std::vector<CellDefect> look_at_overlaps(Terminal &terminal,
                                         const CellFaces &cells)
{
  const std::vector<CellOverlap> found = overlaps(cells, cells.tolerance);
  if (!found.empty())
    terminal.warning(describe_overlaps(cells, found));
  return defects_of(cells, found);
}

/** Show how the contacts of a file of blocks depend on the tolerance. */
void look_at_contacts(Terminal &terminal, const Packing<3> &packing)
{
  const CellFaces &cells = packing.polyhedra();
  if (!(cells.tolerance > 0.))
    return;
  const auto pairs_with = [&](const double factor) {
    return count_contacts(cells,
                          {factor * cells.tolerance, factor * cells.joint_width,
                           cells.joins_edges})
        .pairs_of_cells;
  };
  terminal.stage(
      "Contacts",
      text(counted(count_found(cells, packing.contacts()).pairs_of_cells,
                   "pair"),
           " of blocks within ", cells.tolerance, "; ",
           pairs_with(smaller_tolerance), " within a tenth of that, and ",
           pairs_with(larger_tolerance), " within ten times"));
}

/** What is said of the loads, in a sentence or some. */
std::string verdict_of(const SpaceResults &answer)
{
  if (!answer.is_analysed)
    return "No load acts: nothing but the packing was made.";
  if (!answer.message.empty())
    return answer.message;
  return answer.sentence.empty() ? sentence_of(answer.status, true)
                                 : answer.sentence;
}
} // namespace

void SpaceRun::declare(const NamedSections & /*names*/)
{
  output.add_entries(prm);
  analysis.add_entries(prm);
  add_choice<Accuracy>(
      prm, "Accuracy", accuracy,
      {{Accuracy::draft, "draft",
        "the mean stress of each block, from the forces alone."},
       {Accuracy::standard, "standard",
        "besides, the paper's stress, by Raviart-Thomas elements on tetrahedra "
        "between the centroid and the faces, in " +
            stress_vtu + "."},
       {Accuracy::fine, "fine",
        "besides, the linear stress in each block whose forces and moments "
        "through all faces come closest to those that were found."}},
      "What is computed of the stress inside the blocks.");
  of_scene.add_parameters(prm);
  analysis.add_sections(prm);
  prm.enter_subsection("Output");
  output.add_output(prm);
  add_choice<PackingFile>(
      prm, "Packing", packing_file,
      {{PackingFile::none, "none", "nothing."},
       {PackingFile::off, "OFF", packing_off + ", without names."},
       {PackingFile::obj, "OBJ", packing_obj + ", with the names of groups."},
       {PackingFile::compas, "COMPAS",
        packing_json +
            ", an Assembly with its interfaces, their forces, and supports."}},
      "What to write for another program, or to be read again by the generator "
      "'model'.");
  prm.add_parameter("Report", reports,
                    "Whether to write " + report_html +
                        ", a page that any browser opens, with the blocks to "
                        "be turned, cut and taken apart.",
                    dealii::Patterns::Bool());
  prm.leave_subsection();
}

void SpaceRun::validate(const std::filesystem::path &directory) const
{
  show_settings();
  analysis.check(of_scene,
                 of_scene.blocks(read_packing(directory).packing, terminal),
                 terminal);
  terminal.stage("Valid", "nothing was solved, and nothing written");
}

RunOutcome SpaceRun::carry_out(const std::filesystem::path &directory,
                               const bool writes,
                               PackingsOfRuns *const packings)
{
  show_settings();
  const std::unique_ptr<ResultDirectory> files =
      writes ? open(directory) : nullptr;
  if (writes)
    begin_journal(directory, output);
  analysis.keep_in(writes ? &journal : nullptr);
  SpaceResult result =
      find(directory, packings ? &packings->in_space : nullptr);
  const SpaceResults &answer = result.answer;
  RunOutcome outcome;
  if (answer.is_analysed)
    outcome.status = answer.status;
  outcome.verdict = verdict_of(answer);
  if (files)
  {
    write(*files, result);
    journal.end();
    if (!answer.message.empty())
      outcome.message =
          answer.message + " In " + output.directory + ", " +
          (reports ? report_html + " shows it in a browser, " : "") +
          blocks_vtu + " in ParaView.";
  }
  outcome.summary = summary_of(answer, result.defects);
  return outcome;
}

std::unique_ptr<ResultDirectory>
SpaceRun::open(const std::filesystem::path &directory)
{
  auto files = std::make_unique<ResultDirectory>(output.directory,
                                                 files_of_all_runs(), terminal);
  for (const auto &file : input_files(directory))
    files->protect(file);
  return files;
}

void SpaceRun::write(const std::filesystem::path &directory,
                     SpaceResult &result)
{
  made_of = provenance(directory, output.directory);
  write(*open(directory), result);
}

void SpaceRun::write_page(std::ostream &out, const SpaceResult &result) const
{
  write_packing_report(out, result.answer, output.title, terminal.warnings(),
                       result.defects);
}

SpaceResult SpaceRun::answer(const std::filesystem::path &directory,
                             SharedPackings<CheckedPacking> &packings)
{
  show_settings();
  return find(directory, &packings);
}

SpaceResult SpaceRun::find(const std::filesystem::path &directory,
                           SharedPackings<CheckedPacking> *const packings)
{
  timer.reset(); // what an exception in a run before has left
  if (processes.size() > 1)
    terminal.stage("Processes", std::to_string(processes.size()));
  timer.enter_subsection("packing");
  CheckedPacking checked = packings ? *shared_packing(directory, *packings)
                                    : read_packing(directory);
  timer.leave_subsection();
  timer.enter_subsection("statics");
  SpaceResults answer(analysis.answer(
      of_scene, of_scene.blocks(std::move(checked.packing), terminal),
      terminal));
  timer.leave_subsection();
  if (answer.is_carried())
  {
    answer.reactions = reactions(answer.scene.packing(), answer.forces);
    show_reactions(terminal, answer);
    timer.enter_subsection("stress");
    find_stress(answer);
    timer.leave_subsection();
    show_stress(terminal, answer);
  }
  keep_timings(answer);
  return {std::move(answer), std::move(checked.defects)};
}

void SpaceRun::find_stress(SpaceResults &results) const
{
  terminal.begin("Stress");
  const SpaceScene &scene = results.scene;
  results.mean_stresses = cell_mean_stresses(scene, results.forces);
  if (accuracy == Accuracy::standard)
    results.tetrahedra = tetrahedral_stress(scene, results.forces,
                                            results.mean_stresses, processes);
  else if (accuracy == Accuracy::fine)
    results.stresses =
        linear_stresses(scene, results.forces, results.mean_stresses);
  results.find_principal_stresses();
}

void SpaceRun::keep_timings(SpaceResults &results)
{
  for (const auto &[stage, seconds] :
       timer.get_summary_data(dealii::TimerOutput::total_wall_time))
    results.timings[stage] = seconds;
}

std::shared_ptr<const CheckedPacking>
SpaceRun::shared_packing(const std::filesystem::path &directory,
                         SharedPackings<CheckedPacking> &packings) const
{
  return packings.get(
      SpaceSceneParameters::packing_key(tree()),
      [&] { return read_packing(directory); }, terminal);
}

CheckedPacking
SpaceRun::read_packing(const std::filesystem::path &directory) const
{
  terminal.begin("Packing");
  Packing<3> packing = of_scene.read_packing(directory, terminal);
  for (const std::string &notice : packing.notices())
    terminal.warning(notice);
  show_packing(terminal, packing);
  const CellFaces &cells = packing.polyhedra();
  std::vector<CellDefect> defects = cells.defects;
  if (!cells.file.empty())
  {
    const std::vector<CellDefect> more = look_at_overlaps(terminal, cells);
    defects.insert(defects.end(), more.begin(), more.end());
    look_at_contacts(terminal, packing);
  }
  return {std::move(packing), std::move(defects)};
}

void SpaceRun::write(ResultDirectory &files, SpaceResult &result)
{
  terminal.begin("Output");
  timer.enter_subsection("output");
  SpaceResults &answer = result.answer;
  answer.provenance = made_of;
  const std::vector<CellDefect> &defects = result.defects;
  using Writer = void (*)(std::ostream &, const SpaceResults &);
  const auto add = [&](const std::string &name, const Writer writer) {
    files.write(name, [&](std::ostream &out) { writer(out, answer); });
  };
  add(interfaces_csv, write_interfaces_csv);
  add(cells_csv, write_cells_csv);
  add(boundary_csv, write_boundary_csv);
  if (answer.is_analysed)
    add(interface_points_csv, write_interface_points_csv);
  add(blocks_vtu, write_blocks_vtu);
  add(interfaces_vtu, write_interfaces_vtu);
  std::vector<std::string> grids = {blocks_vtu, interfaces_vtu};
  if (answer.tetrahedra)
  {
    add(stress_vtu, write_tetrahedra_vtu);
    grids.push_back(stress_vtu);
  }
  if (have_places(defects))
  {
    files.write(defects_vtu,
                [&](std::ostream &out) { write_defects_vtu(out, defects); });
    grids.push_back(defects_vtu);
  }
  write_collection(files, grids);
  write_packing(files, answer);
  write_parameters(files, prm);
  if (reports)
    files.write(report_html,
                [&](std::ostream &out) { write_page(out, result); });
  timer.leave_subsection();
  keep_timings(answer);
  files.write(summary_json, [&](std::ostream &out) { // last: a complete set
    write_summary_json(out, answer, output.title, defects);
  });
  files.publish();
  terminal.stage("Output",
                 "written to " + output.directory + "; " +
                     (reports ? report_html + " shows it in a browser, " : "") +
                     results_pvd + " in ParaView");
}

void SpaceRun::write_packing(ResultDirectory &files,
                             const SpaceResults &answer) const
{
  const Packing<3> &packing = answer.scene.packing();
  const CellFaces &cells = packing.polyhedra();
  switch (packing_file)
  {
  case PackingFile::none: break;
  case PackingFile::off:
    files.write(packing_off,
                [&](std::ostream &out) { write_off_model(out, cells); });
    break;
  case PackingFile::obj:
    files.write(packing_obj,
                [&](std::ostream &out) { write_obj_model(out, cells); });
    break;
  case PackingFile::compas:
    files.write(packing_json, [&](std::ostream &out) {
      const FaceContacts contacts = packing.contacts();
      ForcesAtCorners forces;
      for (unsigned int e = 0;
           !answer.forces.empty() && e < contacts.faces.size(); ++e)
      {
        forces.push_back(
            answer.forces.at_vertices(e, packing.polygon(e).size()));
        for (dealii::Tensor<1, 3> &force : forces.back())
          force *= -1.; // on the higher cell
      }
      write_compas_assembly(out, cells, &contacts, forces);
    });
  }
}
} // namespace Voussoir
