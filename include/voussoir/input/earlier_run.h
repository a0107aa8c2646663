// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_input_earlier_run_h
#define voussoir_input_earlier_run_h

#include <voussoir/analyses/state/answer.h>
#include <voussoir/input/csv_reader.h>

#include <filesystem>
#include <optional>
#include <string>

namespace Voussoir
{
/**
 * The results that an earlier run has written, of which the forces are used
 * again: interfaces.csv, cells.csv and summary.json, as csv.h and summary.h
 * have them.
 */
class EarlierRun
{
public:
  /**
   * Read the summary, and no more than the first lines of the others, so that
   * what is missing is found before a packing is made.
   *
   * @throws InputError if @p directory has no forces; the message says which
   *   file or column is missing, or that the run ended in collapse.
   */
  explicit EarlierRun(std::filesystem::path directory);

  /**
   * The forces and displacements, without certificate and status.
   *
   * @param scene of this run.
   * @param record takes how they were found.
   * @throws InputError if the interfaces of @p scene, with their strengths, and
   *   the centres of its cells are not to rounding, and in the same order,
   *   those of the run, or if a line cannot be read; the message has the file,
   *   the line and both values.
   */
  Carried forces(const Scene &scene, SolverRecord &record);

private:
  /** The origin of the forces, as the summary states it. */
  struct Origin
  {
    unsigned int n_cells, n_interfaces;
    SolverRecord record;
    std::optional<double> correction;
  };

  [[noreturn]] void refuse(const std::string &fault) const;
  Origin read_summary() const;
  CsvReader open(const std::string &name) const;
  void check_size(const Packing<2> &packing) const;
  void read_interfaces(const Scene &scene, Carried &found);
  void read_cells(const Packing<2> &packing, Carried &found);
  void read_links(const Scene &scene, Carried &found);

  const std::filesystem::path directory;
  const Origin origin;
  CsvReader interfaces, cells;
  /** True if it is known which interfaces are never pressed. */
  const bool marked;
  /** True if the blocks of that run could turn. */
  const bool turned;
};
} // namespace Voussoir

#endif
