// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_many_runs_h
#define voussoir_run_sweep_many_runs_h

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
} // namespace Voussoir

#endif
