// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_result_writer_h
#define voussoir_run_result_writer_h

#include <voussoir/output/report/details.h>
#include <voussoir/output/result_directory.h>
#include <voussoir/output/results.h>
#include <voussoir/packing/polygons/drawing_faults.h>
#include <voussoir/parallel/process_group.h>
#include <voussoir/run/output_entries.h>
#include <voussoir/stress/reconstruction.h>
#include <voussoir/stress/stress_part.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <iosfwd>
#include <optional>
#include <string>

namespace Voussoir
{
/** The stress inside the blocks, and the files of a run. */
class ResultWriter
{
public:
  /** @param processes the processes that help, beside this one, its root. */
  ResultWriter(Terminal &terminal,
               const ProcessGroup &processes,
               dealii::TimerOutput &timer);

  /** @{ */
  /** Declare the entries outside all sections, and the sections. */
  void add_entries(dealii::ParameterHandler &prm) { entries.add_entries(prm); }
  void add_sections(dealii::ParameterHandler &prm);
  /** @} */

  /** What the terminal shows; 0 to 2. */
  unsigned int verbosity() const { return entries.verbosity; }
  /**
   * The directory of the results, into which the others write.
   *
   * @param forces_from from where forces come; they are not lost there.
   * @throws InputError if nothing can be written there.
   */
  ResultDirectory open(const std::string &forces_from);
  /**
   * Write what shows the faults of a drawing beside earlier results, if that is
   * more than a message can.
   *
   * @return a sentence on where that is, or nothing.
   */
  std::string show_faults(ResultDirectory &files,
                          const DrawingRefused &refused);

  /** @{ */
  /**
   * Complete and write what was found.
   *
   * @param prm the parameters of the run.
   * @return if the load is not carried by what, and which files show it.
   */
  std::string write(ResultDirectory &files,
                    Results &results,
                    const dealii::ParameterHandler &prm);
  std::string write(ResultDirectory &files,
                    Collapse &collapse,
                    const dealii::ParameterHandler &prm);
  /** @} */
  /**
   * Write the page alone.
   *
   * @tparam Found Results, with torques and mean stresses, or Collapse; it gets
   *   its title.
   */
  template <typename Found>
  void write_page(std::ostream &out,
                  Found &found,
                  const dealii::ParameterHandler &prm) const;

  /** How the user names the units. */
  const UnitNames &unit_names() const { return units; }

private:
  /** Kinds of results that are written. */
  enum class ResultFiles
  {
    all,
    csv,
    vtu,
    none
  };

  /** Whether a report is written. */
  enum class Report
  {
    automatic,
    always,
    never
  };

  /** The form in which the packing is written, too. */
  enum class PackingFile
  {
    none,
    wkt,
    off
  };

  /** @{ */
  /** Declare the entries of a section. */
  void add_output(dealii::ParameterHandler &prm);
  void add_units(dealii::ParameterHandler &prm);
  /** @} */
  /** True if results of that kind are to be written. */
  bool writes(ResultFiles kind) const;
  /** True if there is to be a report on @p packing. */
  bool reports(const Packing<2> &packing) const;
  /**
   * Add to @p results what follows from the forces and is asked for.
   *
   * @return the root's part of the stress inside the cells, if there are more
   *   processes than one.
   */
  std::optional<StressPart> find_stresses(Results &results);
  /** Write the stress inside the cells. @return the name of the file. */
  std::string write_stress(ResultDirectory &files,
                           const Results &results,
                           const std::optional<StressPart> &own_part) const;
  /** Write a motion of the blocks of @p scene; in the grid times @p factor. */
  void write_mechanism(ResultDirectory &files,
                       const Scene &scene,
                       const Motion &motion,
                       double factor,
                       const LiveLoads *live = nullptr) const;
  /** Write the cells for another program, and the gaps that were left. */
  void write_packing(ResultDirectory &files, const Packing<2> &packing) const;
  /** Add what every run writes, and put all files in place. */
  template <typename Found>
  void publish(ResultDirectory &files,
               Found &found,
               const dealii::ParameterHandler &prm);

  Terminal &terminal;
  const ProcessGroup &processes;
  dealii::TimerOutput &timer;
  OutputEntries entries;
  ResultFiles result_files = ResultFiles::all;
  PackingFile packing_file = PackingFile::none;
  Report report = Report::automatic;
  UnitNames units;
  StressParameters stress;
  /** True if forces are from the directory that the results go to. */
  bool keeps_forces = false;
};
} // namespace Voussoir

#endif
