// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_sweep_runner_h
#define voussoir_run_sweep_sweep_runner_h

#include <voussoir/output/result_directory.h>
#include <voussoir/run/sweep/many_runs.h>
#include <voussoir/run/sweep/repeated_run.h>
#include <voussoir/run/sweep/sweep_page.h>
#include <voussoir/terminal/terminal.h>

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** All runs of a sweep or a search, and their files. */
class SweepRunner
{
public:
  /**
   * @param names of directories, beside those of all runs, that write_results()
   *   will be given.
   * @throws InputError if the files cannot be written, or would overwrite what
   *   the scene is read from.
   */
  SweepRunner(const ManyRuns &wanted,
              const std::vector<ChangingEntry> &changing,
              const std::vector<std::string> &names,
              Terminal &terminal);

  /** Run all @p points. @return the number of the first of them in runs(). */
  std::size_t run(const std::vector<std::vector<std::string>> &points);

  /** All runs so far. */
  const std::vector<SweepRun> &runs() const { return done; }
  /** The names of what changes. */
  const std::vector<std::string> &names() const { return names_of_entries; }

  /**
   * Write all results of some runs into directories of these names; each is run
   * again, unless it has a directory of its own, which is copied. Then the page
   * of all runs leads there.
   */
  void write_results(
      const std::vector<std::pair<std::string, std::size_t>> &of_runs);

  /**
   * Write the table of all runs and its page, and say so with the warnings.
   * Results to which the page of an earlier sweep or search leads, and which
   * this one has not written, are removed; those of all runs stay.
   */
  void write(std::optional<SearchEnds> ends = {});

  /**
   * Refuse a result that no run has, when all have ended: what one does not
   * have another may.
   */
  void check_results() const;

private:
  static ResultDirectory open(const RepeatedRun &scene,
                              const ManyRuns &wanted,
                              const std::vector<std::string> &directories,
                              Terminal &terminal);
  void look_at_results(const SweepRun &first);
  SweepRun run_into(const std::string &name,
                    const std::vector<std::string> &values);
  std::string name_of(std::size_t run) const;
  std::string page_in(const std::string &name) const;
  void copy_results(const std::string &from, const std::string &to);
  void remove_earlier_results() const;

  const ManyRuns &wanted;
  const std::vector<std::string> names_of_entries;
  Terminal &terminal;
  RepeatedRun scene;
  ResultDirectory files;
  std::vector<SweepRun> done;
  /** The directories of write_results() so far. */
  std::vector<std::string> written;
  std::mutex of_terminal;
};

/** @{ */
/** The directories that sweeps and searches write besides those of all runs. */
inline const std::string critical_directory = "critical";
inline const std::string carried_directory = "carried";
inline const std::string collapses_directory = "collapses";
/** @} */
} // namespace Voussoir

#endif
