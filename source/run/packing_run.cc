// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/csv.h>
#include <voussoir/output/polyhedra_csv.h>
#include <voussoir/output/summary/packing_summary.h>
#include <voussoir/output/summary/summary.h>
#include <voussoir/output/vtu/blocks_vtu.h>
#include <voussoir/output/vtu/interfaces_vtu.h>
#include <voussoir/output/vtu/polyhedra_vtu.h>
#include <voussoir/output/vtu/pvd.h>
#include <voussoir/packing/polyhedra/cell_overlaps.h>
#include <voussoir/run/packing_run.h>

#include <ostream>

namespace Voussoir
{
namespace
{
/** The factors by which a tolerance is changed, to see whether it matters. */
constexpr double smaller_tolerance = 0.1, larger_tolerance = 10.;

/** Show what a file of blocks may hide: overlaps, and contacts in doubt. */
void look_at_model(Terminal &terminal, const CellFaces &cells)
{
  const std::vector<CellOverlap> found = overlaps(cells, cells.tolerance);
  if (!found.empty())
    terminal.warning(describe_overlaps(cells, found));
  const auto pairs_with = [&](const double factor) {
    return count_contacts(
               cells, {factor * cells.tolerance, factor * cells.joint_width})
        .pairs_of_cells;
  };
  if (cells.tolerance > 0.)
    terminal.stage("Contacts",
                   text(pairs_with(1.), " pairs of blocks within ",
                        cells.tolerance, "; ", pairs_with(smaller_tolerance),
                        " within a tenth of that, and ",
                        pairs_with(larger_tolerance), " within ten times"));
}
} // namespace

void PackingRun::declare(const std::set<std::string> & /*load_cases*/)
{
  output.add_entries(prm);
  packing_parameters.add_parameters(prm);
  supports.add_parameters(prm);
  prm.enter_subsection("Output");
  output.add_verbosity(prm);
  prm.leave_subsection();
}

void PackingRun::validate(const std::filesystem::path &directory) const
{
  warn_of_unused();
  read_packing(directory);
  terminal.stage("Valid", "nothing was written");
}

std::string PackingRun::carry_out(const std::filesystem::path &directory)
{
  warn_of_unused();
  ResultDirectory files(output.directory, files_of_all_runs(), terminal);
  for (const auto &file : packing_parameters.input_files(directory))
    files.protect(file);
  write(files, read_packing(directory));
  return {};
}

Packing<3>
PackingRun::read_packing(const std::filesystem::path &directory) const
{
  terminal.begin("Packing");
  Packing<3> packing =
      supports.support(packing_parameters.make_packing(directory, terminal));
  for (const std::string &notice : packing.notices())
    terminal.warning(notice);
  show_packing(terminal, packing);
  if (!packing.polyhedra().file.empty())
    look_at_model(terminal, packing.polyhedra());
  return packing;
}

void PackingRun::write(ResultDirectory &files, const Packing<3> &packing) const
{
  terminal.begin("Output");
  using Writer = void (*)(std::ostream &, const Packing<3> &);
  const auto add = [&](const std::string &name, const Writer writer) {
    files.write(name, [&](std::ostream &out) { writer(out, packing); });
  };
  add(interfaces_csv, write_interfaces_csv);
  add(cells_csv, write_cells_csv);
  add(boundary_csv, write_boundary_csv);
  add(blocks_vtu, write_blocks_vtu);
  add(interfaces_vtu, write_interfaces_vtu);
  write_collection(files, {blocks_vtu, interfaces_vtu});
  write_parameters(files, prm);
  files.write(summary_json, [&](std::ostream &out) { // last: a complete set
    write_summary_json(out, packing, output.title);
  });
  files.publish();
  terminal.stage("Output", "written to " + output.directory + "; " +
                               results_pvd + " shows it in ParaView");
}
} // namespace Voussoir
