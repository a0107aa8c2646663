// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_analysis_run_h
#define voussoir_run_analysis_run_h

#include <voussoir/base/parameters/assigned_entries.h>
#include <voussoir/base/parameters/print_parameters.h>
#include <voussoir/parallel/process_group.h>
#include <voussoir/run/result_writer.h>
#include <voussoir/run/scene_analysis.h>
#include <voussoir/run/shared_packings.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** The places that the parameters of a run are written in, in their order. */
struct ParameterSources
{
  /** A file; see ParameterInput. */
  std::optional<std::filesystem::path> file;
  /** Lines as in a .prm file. */
  std::string text = {};
  /** Assignments as in --set. */
  std::vector<std::string> assignments = {};
};

/** What a run ends with that has found an answer. */
struct RunOutcome
{
  /** The answer. */
  RunResult result;
  /**
   * If the load is not carried and the files are written: by what, and which of
   * them show it. Empty otherwise.
   */
  std::string message;
};

/**
 * One run, from the parameters to the files: packing, analysis, stress, output.
 * The program has one, a sweep one for each of its runs, and a scene of
 * Python's one that it runs again and again.
 */
class AnalysisRun
{
public:
  /**
   * @param terminal sees what the run notices.
   * @param processes the processes that help, beside this one, its root.
   */
  explicit AnalysisRun(Terminal &terminal,
                       const ProcessGroup &processes = ProcessGroup());

  /**
   * Declare all parameters, with the load cases that the sources name, and read
   * them; to be called once.
   *
   * @throws InputError as ParameterInput and assign() do.
   */
  void read(const ParameterSources &sources);
  /**
   * Carry out one more assignment "Section/Name=value".
   *
   * @throws InputError as assign_parameter() does.
   */
  void assign(const std::string &assignment);
  /** Take polygons as the packing; see PackingParameters::give(). */
  void give(PolygonList polygons) { analysis.give(std::move(polygons)); }

  /** The entries with their values. */
  const dealii::ParameterHandler &entries() const { return prm; }
  /** They as tree_of() gives them. */
  const nlohmann::ordered_json &tree() const { return assigned.tree(); }
  /**
   * Print the entries in a section, such as "Packing/wall", or all if it is
   * empty: a listing, or the values alone of those that somebody has set.
   *
   * @throws InputError if there is no such section.
   */
  void print(std::ostream &out,
             const std::string &section,
             ParameterFormat format,
             Detail detail);
  /** What the terminal is to show; 0 to 2. */
  unsigned int verbosity() const { return writer.verbosity(); }

  /** @{ */
  /** @param directory that of the file of parameters, where paths begin. */
  /** Files that the scene is read from. */
  auto input_files(const std::filesystem::path &directory) const
  {
    return analysis.input_files(directory);
  }
  /**
   * The packing with its supports, from those that are shared if they have it.
   *
   * @throws InputError.
   */
  std::shared_ptr<const Packing<2>>
  shared_packing(const std::filesystem::path &directory,
                 SharedPackings &packings) const;
  /**
   * Read the scene and show what was understood; nothing is solved, and nothing
   * written.
   *
   * @throws InputError.
   */
  void validate(const std::filesystem::path &directory) const;
  /**
   * Answer the question of the parameters.
   *
   * @param writes whether the results are written, with the parameters beside
   *   them.
   * @param packings that are shared with other runs, if there are any.
   * @throws InputError, SolverError.
   */
  RunOutcome run(const std::filesystem::path &directory,
                 bool writes,
                 SharedPackings *packings = nullptr);
  /** @} */

private:
  void warn_of_unused() const;
  /** Where results go, with the files protected that the scene is read from. */
  std::unique_ptr<ResultDirectory> open(const std::filesystem::path &directory);
  /**
   * Read the packing; if a drawing is refused, write what shows its faults
   * beside earlier results.
   */
  Packing<2> read_packing(const std::filesystem::path &directory,
                          ResultDirectory *files);

  Terminal &terminal;
  const ProcessGroup processes;
  /** The wall clock times of the stages. */
  dealii::TimerOutput timer;
  /** The scene and the question about it. */
  SceneAnalysis analysis;
  /** What is done with the answer. */
  ResultWriter writer;
  dealii::ParameterHandler prm;
  AssignedEntries assigned;
};
} // namespace Voussoir

#endif
