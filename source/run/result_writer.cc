// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/capacity/capacity_curve.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/output/csv.h>
#include <voussoir/output/report/report.h>
#include <voussoir/output/summary/messages.h>
#include <voussoir/output/summary/summary.h>
#include <voussoir/output/vtu/blocks_vtu.h>
#include <voussoir/output/vtu/drawing_check_vtu.h>
#include <voussoir/output/vtu/interfaces_vtu.h>
#include <voussoir/output/vtu/packing_files.h>
#include <voussoir/output/vtu/pvd.h>
#include <voussoir/output/vtu/stress_pieces.h>
#include <voussoir/output/vtu/stress_vtu.h>
#include <voussoir/run/output_entries.h>
#include <voussoir/run/result_writer.h>
#include <voussoir/run/unused_settings.h>
#include <voussoir/stress/cell_means.h>

#include <boost/algorithm/string/join.hpp>

#include <cmath>
#include <system_error>
#include <tuple>
#include <utility>

namespace Voussoir
{
namespace
{
/** What the largest displacement of a mechanism, one, is drawn as: a cell. */
double size_of_mechanism(const Scene &scene)
{
  return std::sqrt(scene.packing.area() / scene.packing.n_cells());
}

void add_grids_of_mechanism(const Scene &scene, std::vector<std::string> &grids)
{
  grids.insert(grids.end(), {mechanism_vtu, mechanism_joints_vtu});
  if (!scene.links.empty())
    grids.push_back(mechanism_links_vtu);
}
} // namespace

ResultWriter::ResultWriter(Terminal &terminal,
                           const ProcessGroup &processes,
                           dealii::TimerOutput &timer)
    : terminal(terminal), processes(processes), timer(timer)
{}

void ResultWriter::add_sections(dealii::ParameterHandler &prm)
{
  stress.add_parameters(prm);
  prm.enter_subsection("Output");
  add_output(prm);
  prm.leave_subsection();
  prm.enter_subsection("Units");
  add_units(prm);
  prm.leave_subsection();
}

void ResultWriter::add_output(dealii::ParameterHandler &prm)
{
  entries.add_verbosity(prm);
  add_choice<ResultFiles>(
      prm, "Files", result_files,
      {{ResultFiles::all, "all", "both kinds."},
       {ResultFiles::csv, "csv",
        interfaces_csv + ", " + cells_csv + " and " + boundary_csv +
            ", or those of the mechanism."},
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
  add_choice<Report>(
      prm, "Report", report,
      {{Report::automatic, "automatic",
        "if 'Files = all', up to " + std::to_string(most_cells_in_full) +
            " cells."},
       {Report::always, "true",
        "always; with more cells it shows less, and is large."},
       {Report::never, "false", "never."}},
      "Whether to write " + report_html +
          ", a page with pictures and numbers that any browser opens.");
}

void ResultWriter::add_units(dealii::ParameterHandler &prm)
{
  for (const auto &[name, unit, of] :
       {std::tuple("Length", &units.length, "lengths"),
        std::tuple("Stress", &units.stress, "stresses and strengths"),
        std::tuple(
            "Force", &units.force,
            "forces, which are stress times length, per unit thickness")})
    prm.add_parameter(name, *unit,
                      std::string("The unit of ") + of + ", for " +
                          report_html + ". Nothing is converted.",
                      dealii::Patterns::Anything());
}

ResultDirectory ResultWriter::open(const std::string &forces_from)
{
  std::error_code not_there;
  keeps_forces =
      !forces_from.empty() &&
      std::filesystem::equivalent(forces_from, entries.directory, not_there);
  return {entries.directory, files_of_all_runs(), terminal};
}

std::string ResultWriter::show_faults(ResultDirectory &files,
                                      const DrawingRefused &refused)
{
  // The message of one fault shows where it is.
  if (!writes(ResultFiles::vtu) || refused.check.faults.size() < 2)
    return {};
  const bool has_page = report != Report::never;
  files.write(drawing_check_vtu, [&](std::ostream &out) {
    write_drawing_check_vtu(out, refused.check);
  });
  if (has_page)
    files.write(drawing_check_html,
                [&](std::ostream &out) { write_report(out, refused); });
  files.publish_beside();
  const std::filesystem::path directory = entries.directory;
  return text(
      "All are in '", (directory / drawing_check_vtu).string(),
      "'; open it in ParaView",
      has_page ? ", or " + drawing_check_html + " beside it in a browser" : "",
      ".");
}

bool ResultWriter::writes(const ResultFiles kind) const
{
  // Forces from the directory of the results are not lost there, whatever
  // 'Files' says: publish() removes what is not written.
  return result_files == ResultFiles::all || result_files == kind ||
         (kind == ResultFiles::csv && keeps_forces);
}

bool ResultWriter::reports(const Packing<2> &packing) const
{
  return report == Report::always ||
         (report == Report::automatic && result_files == ResultFiles::all &&
          packing.n_cells() <= most_cells_in_full);
}

std::string ResultWriter::write(ResultDirectory &files,
                                Results &results,
                                const dealii::ParameterHandler &prm)
{
  results.title = entries.title;
  timer.enter_subsection("stress");
  terminal.begin("Stress");
  const std::optional<StressPart> own_part = find_stresses(results);
  timer.leave_subsection();

  timer.enter_subsection("output");
  terminal.begin("Output");
  const MotionBeside *const beside = results.motion_beside();
  using Writer = void (*)(std::ostream &, const Results &);
  const auto add = [&](const std::string &name, const Writer writer) {
    files.write(name, [&](std::ostream &out) { writer(out, results); });
  };
  if (writes(ResultFiles::csv))
  {
    add(interfaces_csv, write_interfaces_csv);
    add(cells_csv, write_cells_csv);
    add(boundary_csv, write_boundary_csv);
    if (!results.scene.links.empty())
      add(links_csv, write_links_csv);
    if (results.data<CapacityCurve>() != nullptr)
      add(capacity_csv, write_capacity_csv);
  }
  if (writes(ResultFiles::vtu))
  {
    std::vector<std::string> grids = {blocks_vtu, interfaces_vtu};
    add(blocks_vtu, write_blocks_vtu);
    if (stress.reconstruct())
      grids.insert(grids.begin(), write_stress(files, results, own_part));
    add(interfaces_vtu, write_interfaces_vtu);
    if (!results.scene.links.empty())
    {
      add(links_vtu, write_links_vtu);
      grids.push_back(links_vtu);
    }
    if (beside)
      add_grids_of_mechanism(results.scene, grids);
    write_collection(files, grids);
  }
  if (beside)
    write_mechanism(files, results.scene, beside->motion,
                    beside->has_size ? 1. : size_of_mechanism(results.scene),
                    beside->live ? &*beside->live : nullptr);
  publish(files, results, prm);
  show_summary(terminal, results);
  return {};
}

std::optional<StressPart> ResultWriter::find_stresses(Results &results)
{
  const bool has_them = !results.mean_stresses.empty(); // and others see them
  if (!has_them && (writes(ResultFiles::csv) || writes(ResultFiles::vtu) ||
                    reports(results.scene.packing)))
  {
    results.torques = residual_torques(results.scene, results.forces);
    results.mean_stresses = cell_mean_stresses(results.scene, results.forces);
  }
  std::optional<StressPart> own_part;
  if (!stress.reconstruct() || !writes(ResultFiles::vtu))
    return own_part;

  // Links are no sides of cells.
  std::optional<Scene> loaded;
  if (!results.scene.links.empty())
    loaded.emplace(loaded_by_links(results.scene, results.forces));
  const Scene &scene = loaded ? *loaded : results.scene;
  const Reconstruction how = stress.reconstruction();
  if (!scene.packing.not_seen_whole().empty())
  {
    results.pieces.emplace(scene.packing);
    results.stress = reconstruct_stress(
        results.pieces->as_packing(),
        results.pieces->forces(scene, results.forces), how, terminal);
    results.stress.undetermined =
        results.pieces->cells_of(results.stress.undetermined);
  }
  else if (processes.size() == 1)
    results.stress = reconstruct_stress(scene, results.forces, how, terminal);
  else
  {
    own_part.emplace(reconstruct_on_root(scene, results.forces, results.motion,
                                         how, processes, terminal));
    results.stress.n_sub_cells = own_part->stress.n_sub_cells;
    results.stress.undetermined = own_part->stress.undetermined;
  }
  terminal.stage("Stress", text(results.stress.n_sub_cells, " sub-cells"));
  for (const std::string &warning : undetermined_cells(scene, results.stress))
    terminal.warning(warning);
  return own_part;
}

std::string
ResultWriter::write_stress(ResultDirectory &files,
                           const Results &results,
                           const std::optional<StressPart> &own_part) const
{
  if (own_part)
  {
    write_stress_pieces(files, *own_part, processes);
    return stress_pvtu;
  }
  files.write(stress_vtu, [&](std::ostream &out) {
    if (!results.pieces)
      return write_stress_vtu(
          out, {results.scene.packing, results.stress, results.motion});
    const Motion motion = results.pieces->motion(results.motion);
    write_stress_vtu(out, {results.pieces->as_packing(), results.stress, motion,
                           0, &results.pieces->cell_of()});
  });
  return stress_vtu;
}

std::string ResultWriter::write(ResultDirectory &files,
                                Collapse &collapse,
                                const dealii::ParameterHandler &prm)
{
  collapse.title = entries.title;
  timer.enter_subsection("output");
  terminal.begin("Output");
  write_mechanism(files, collapse.scene, collapse.motion,
                  size_of_mechanism(collapse.scene));
  std::vector<std::string> to_look_at;
  if (writes(ResultFiles::vtu))
  {
    std::vector<std::string> grids;
    add_grids_of_mechanism(collapse.scene, grids);
    write_collection(files, grids);
    to_look_at.push_back(results_pvd);
  }
  if (writes(ResultFiles::csv))
    to_look_at.push_back(mechanism_joints_csv);
  publish(files, collapse, prm);
  terminal.status(Status{Status::Kind::collapse, 0.}.word(), false);
  return message_of(collapse, boost::algorithm::join(to_look_at, " and "));
}

void ResultWriter::write_mechanism(ResultDirectory &files,
                                   const Scene &scene,
                                   const Motion &motion,
                                   const double factor,
                                   const LiveLoads *const live) const
{
  const auto add = [&](const std::string &name, const auto &writer) {
    files.write(name, [&](std::ostream &out) { writer(out, scene, motion); });
  };
  if (writes(ResultFiles::vtu))
  {
    files.write(mechanism_vtu, [&](std::ostream &out) {
      write_mechanism_vtu(out, scene, motion, factor);
    });
    add(mechanism_joints_vtu, write_mechanism_joints_vtu);
    if (!scene.links.empty())
      add(mechanism_links_vtu, write_mechanism_links_vtu);
  }
  if (writes(ResultFiles::csv))
  {
    files.write(mechanism_csv, [&](std::ostream &out) {
      write_mechanism_csv(out, scene, motion, live);
    });
    add(mechanism_joints_csv, write_mechanism_joints_csv);
    if (!scene.links.empty())
      add(mechanism_links_csv, write_mechanism_links_csv);
  }
}

void ResultWriter::write_packing(ResultDirectory &files,
                                 const Packing<2> &packing) const
{
  const auto add = [&](const std::string &name, const auto &writer) {
    files.write(name, [&](std::ostream &out) { writer(out, packing); });
  };
  if (writes(ResultFiles::vtu) && !packing.gaps().empty())
    add(drawing_check_vtu, [](std::ostream &out, const Packing<2> &of) {
      write_drawing_check_vtu(out, check_of_gaps(of));
    });
  if (packing_file == PackingFile::wkt)
    add(packing_wkt, write_packing_wkt);
  if (packing_file == PackingFile::off)
    add(packing_off, write_packing_off);
  if (packing_file != PackingFile::none)
    add(packing_centres, write_centres);
}

template <typename Found>
void ResultWriter::write_page(std::ostream &out,
                              Found &found,
                              const dealii::ParameterHandler &prm) const
{
  found.title = entries.title;
  write_report(out, found, {units, changed_settings(prm), terminal.warnings()});
}

template void ResultWriter::write_page(std::ostream &,
                                       Results &,
                                       const dealii::ParameterHandler &) const;
template void ResultWriter::write_page(std::ostream &,
                                       Collapse &,
                                       const dealii::ParameterHandler &) const;

template <typename Found>
void ResultWriter::publish(ResultDirectory &files,
                           Found &found,
                           const dealii::ParameterHandler &prm)
{
  write_packing(files, found.scene.packing);
  write_parameters(files, prm);
  timer.leave_subsection();
  for (const auto &[stage, seconds] :
       timer.get_summary_data(dealii::TimerOutput::total_wall_time))
    found.timings[stage] = seconds; // others are from before, as of Python
  const bool has_page = reports(found.scene.packing);
  if (has_page)
    files.write(report_html,
                [&](std::ostream &out) { write_page(out, found, prm); });
  files.write(summary_json, [&](std::ostream &out) {
    write_summary_json(out, found); // last: it marks a complete set
  });
  files.publish();
  std::vector<std::string> views;
  if (has_page)
    views.push_back(report_html + " shows it in a browser");
  if (writes(ResultFiles::vtu))
    views.push_back(results_pvd + " in ParaView");
  terminal.stage(
      "Output",
      "written to " + entries.directory +
          (views.empty() ? "" : "; " + boost::algorithm::join(views, ", ")));
}
} // namespace Voussoir
