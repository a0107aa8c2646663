// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameter_input.h>
#include <voussoir/output/csv.h>
#include <voussoir/output/polyhedra_csv.h>
#include <voussoir/output/report/report.h>
#include <voussoir/output/summary/summary.h>
#include <voussoir/output/vtu/blocks_vtu.h>
#include <voussoir/output/vtu/defects_vtu.h>
#include <voussoir/output/vtu/drawing_check_vtu.h>
#include <voussoir/output/vtu/interfaces_vtu.h>
#include <voussoir/output/vtu/packing_files.h>
#include <voussoir/output/vtu/pvd.h>
#include <voussoir/output/vtu/stress_pieces.h>
#include <voussoir/output/vtu/stress_vtu.h>
#include <voussoir/run/output_entries.h>

namespace Voussoir
{
void OutputEntries::add_entries(dealii::ParameterHandler &prm)
{
  using dealii::Patterns::Anything;
  prm.add_parameter("Title", title, "A title for the results.", Anything());
  prm.add_parameter("Output directory", directory,
                    "Where the results go; created if need be. A relative path "
                    "starts at the directory that the program is run in.",
                    Anything());
}

void OutputEntries::add_output(dealii::ParameterHandler &prm)
{
  prm.add_parameter(
      "Verbosity", verbosity,
      "0: the closing summary alone; 1: also the stages and, on a "
      "screen, the progress of long ones; 2: also the iterations "
      "of the solver and the joints of which the most is used.",
      dealii::Patterns::Integer(0, 2));
  prm.add_parameter(
      "Checkpoint after", checkpoint_after,
      "The seconds after which a run keeps what it has found, in " +
          checkpoint_file +
          " of the output directory, every ten seconds or more, until the "
          "results are written: load factors and ranges, and the runs of a "
          "sweep. If it is interrupted or killed, --resume goes on from there "
          "and ends with the same results. 0: from the start.",
      dealii::Patterns::Double(0.));
}

FilesOfRuns files_of_all_runs()
{
  return {
      {interfaces_csv,       cells_csv,           boundary_csv,
       capacity_csv,         links_csv,           links_vtu,
       mechanism_links_csv,  mechanism_links_vtu, blocks_vtu,
       interfaces_vtu,       stress_vtu,          stress_pvtu,
       drawing_check_vtu,    defects_vtu,         mechanism_csv,
       mechanism_joints_csv, mechanism_vtu,       mechanism_joints_vtu,
       interface_points_csv, results_pvd,         report_html,
       drawing_check_html,   parameters_prm,      summary_json},
      {packing_wkt, packing_off, packing_obj, packing_json, packing_centres},
      is_stress_piece};
}

void write_parameters(ResultDirectory &files,
                      const dealii::ParameterHandler &prm)
{
  files.write(parameters_prm, [&](std::ostream &out) {
    using Style = dealii::ParameterHandler;
    out << listing_title() << '\n';
    prm.print_parameters(out, Style::ShortPRM | Style::KeepDeclarationOrder);
  });
}

void write_collection(ResultDirectory &files,
                      const std::vector<std::string> &grids)
{
  files.write(results_pvd, [&](std::ostream &out) { write_pvd(out, grids); });
}
} // namespace Voussoir
