// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_sweep_files_h
#define voussoir_run_sweep_sweep_files_h

#include <voussoir/run/sweep/repeated_run.h>

#include <cstddef>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** @{ */
/** The names of the table of all runs, and of the page with its plots. */
inline const std::string sweep_csv = "sweep.csv";
inline const std::string sweep_html = "sweep.html";
/** @} */

/** A column of numbers: its name, and where summary.json has them. */
using SweepColumn = std::pair<std::string, std::string>;

/** The columns of every sweep. */
extern const std::vector<SweepColumn> sweep_columns;

/** The status of a run in one word. */
std::string word_of(const SweepRun &run);

/** The class of a verdict in a style sheet, for its colour. */
std::string kind_of_verdict(const SweepRun &run);

/** How often each status is there: "12 solved, 8 collapse". */
std::string counts_of(const std::vector<SweepRun> &runs);

/** A warning that some of many runs have. */
struct SharedWarning
{
  /** The sentence. */
  std::string text;
  /** The runs that have it, by their numbers, ascending. */
  std::vector<std::size_t> runs;

  /**
   * The sentence behind "In all runs: ", or which they are.
   *
   * @param names of the parameters.
   * @param all the runs.
   */
  std::string description(const std::vector<std::string> &names,
                          const std::vector<SweepRun> &all) const;
};

/** Each warning of the runs once, in the order of the first run with it. */
std::vector<SharedWarning> warnings_of(const std::vector<SweepRun> &runs);

/**
 * Write the table of all runs.
 *
 * @param names of the parameters.
 * @param results numbers of summary.json, as in "ground/reaction/1".
 * @param runs in the order of the lines.
 */
void write_sweep_csv(std::ostream &out,
                     const std::vector<std::string> &names,
                     const std::vector<std::string> &results,
                     const std::vector<SweepRun> &runs);
} // namespace Voussoir

#endif
