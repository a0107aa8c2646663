// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_sweep_h
#define voussoir_run_sweep_sweep_h

#include <voussoir/run/sweep/sweep_values.h>
#include <voussoir/terminal/terminal.h>

#include <filesystem>
#include <string>
#include <vector>

namespace Voussoir
{
/** A scene to run many times, and what is wanted of it. */
struct ManyRuns
{
  /** The .prm file. */
  std::filesystem::path file;
  /** As in --set, the same in all runs. */
  std::vector<std::string> assignments;
  /** Numbers of summary.json, as in "ground/reaction/1". */
  std::vector<std::string> results;
  /** True to write the results of each run into a directory of its own. */
  bool has_directories = false;
  /** True to write those of the least load factor, into `critical`. */
  bool writes_critical = false;
};

/**
 * Run a scene with all combinations of the values of @p axes, as many at a time
 * as there are cores, and write sweep.csv and sweep.html into its output
 * directory. With load factors say between which they are, and where.
 *
 * @throws InputError if some values are wrong: then nothing is written.
 * @throws SolverError if the solver failed in some runs; all are written.
 */
void sweep(const ManyRuns &runs,
           const std::vector<SweepAxis> &axes,
           Terminal &terminal);

/**
 * Look for the value of a parameter at which the verdict changes, between
 * values at which the load is carried and collapses, each by its certificate.
 * The search is right if it changes once in the range. Write sweep.csv and
 * sweep.html with all runs.
 *
 * @throws InputError if a value is wrong, or both ends have the same verdict.
 * @throws SolverError if a run has no verdict, with its value.
 */
void search(const ManyRuns &runs, const SearchRange &range, Terminal &terminal);
} // namespace Voussoir

#endif
