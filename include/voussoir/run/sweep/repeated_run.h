// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_repeated_run_h
#define voussoir_run_sweep_repeated_run_h

#include <voussoir/analyses/state/status.h>
#include <voussoir/run/shared_packings.h>
#include <voussoir/run/sweep/sweep_values.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** What one of many runs found: an answer, a solver that failed, or nothing to
 * be solved. */
struct SweepRun
{
  /** The values that were assigned. */
  std::vector<std::string> values;
  /** False if the solver failed. */
  bool has_answer = false;
  /** True if the load factor has nothing to multiply, and there is no answer.
   */
  bool is_unloaded = false;
  /** True if the least load factor is looked for. */
  bool seeks_least = false;
  /** RunOutcome::status; none either without an answer. */
  std::optional<Status::Kind> verdict;
  /** RunOutcome::verdict. */
  std::string sentence;
  /** RunOutcome::summary. */
  nlohmann::ordered_json summary;
  /** What a run alone would print. */
  std::vector<std::string> warnings;
  /** The message of a solver that failed, or of a scene without live loads. */
  std::string reason;
  /** The page of its results, from the directory of sweep.csv; or none. */
  std::string page;
  /** Wall clock time, in seconds. */
  double seconds = 0.;
};

/**
 * A scene, in the plane or in space, that is run again and again with other
 * values of some parameters, in any number of threads. Runs of the same packing
 * share it.
 */
class RepeatedRun
{
public:
  /**
   * @param file of parameters.
   * @param assignments as in --set, which come before the values.
   * @param changing what changes from run to run.
   */
  RepeatedRun(std::filesystem::path file,
              std::vector<std::string> assignments,
              std::vector<ChangingEntry> changing);

  /** The entry `Title`. */
  const std::string &title() const { return of_scene; }
  /** The entry `Output directory`. */
  const std::string &output_directory() const { return directory; }
  /** Files that the scene is read from, without the values. */
  const std::vector<std::filesystem::path> &input_files() const
  {
    return inputs;
  }
  /** What tells the scene from others, without the values; identity_of(). */
  const nlohmann::ordered_json &identity() const { return of_input; }
  /** The entry `Output/Checkpoint after`. */
  double checkpoint_after() const { return seconds_to_checkpoint; }
  /** The entry `Forces from`; empty if there is none. */
  const std::string &forces_from() const { return of_forces; }

  /**
   * Run it with @p values, one for each that changes.
   *
   * @param results the directory in which the files of this run are put; empty
   *   to write none.
   * @throws InputError if a value is wrong; the message names it.
   */
  SweepRun run(const std::vector<std::string> &values,
               const std::string &results);

  /**
   * What tells a run with these @p values from others, and the contents of the
   * files that they name.
   */
  std::string key(const std::vector<std::string> &values) const;

private:
  std::vector<std::string>
  assignments_with(const std::vector<std::string> &values) const;

  const std::filesystem::path file;
  const std::vector<std::string> assignments;
  const std::vector<ChangingEntry> changing;
  /** Where relative paths begin. */
  std::filesystem::path origin;
  std::string of_scene, directory, of_forces;
  nlohmann::ordered_json of_input;
  double seconds_to_checkpoint;
  std::vector<std::filesystem::path> inputs;
  PackingsOfRuns packings;
};

/** @{ */
/** A run as a tree, and back, with all digits. */
nlohmann::ordered_json json_of(const SweepRun &run);
SweepRun sweep_run_of(const nlohmann::ordered_json &json);
/** @} */

/** The names of what changes. */
std::vector<std::string> names_of(const std::vector<ChangingEntry> &changing);

/** "Friction/Strength = 0.2, Rotations = true". */
std::string words_of(const std::vector<std::string> &names,
                     const std::vector<std::string> &values);
} // namespace Voussoir

#endif
