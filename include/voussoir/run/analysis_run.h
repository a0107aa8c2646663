// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_analysis_run_h
#define voussoir_run_analysis_run_h

#include <voussoir/parallel/process_group.h>
#include <voussoir/run/result_writer.h>
#include <voussoir/run/run.h>
#include <voussoir/run/scene_analysis.h>
#include <voussoir/run/shared_packings.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/timer.h>

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <utility>

namespace Voussoir
{
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
 * A run in the plane: packing, analysis, stress, output. The program has one, a
 * sweep one for each of its runs, and a scene of Python's one that it runs
 * again and again.
 */
class AnalysisRun : public Run
{
public:
  /**
   * @param terminal sees what the run notices.
   * @param processes the processes that help, beside this one, its root.
   */
  explicit AnalysisRun(Terminal &terminal,
                       const ProcessGroup &processes = ProcessGroup());

  /** Take polygons as the packing; see PackingParameters::give(). */
  void give(PolygonList polygons) { analysis.give(std::move(polygons)); }

  /** What the terminal is to show; 0 to 2. */
  unsigned int verbosity() const override { return writer.verbosity(); }

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
  void validate(const std::filesystem::path &directory) const override;
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
  std::string carry_out(const std::filesystem::path &directory) override;
  /** @} */

protected:
  void declare(const std::set<std::string> &load_cases) override;

private:
  /** Where results go, with the files protected that the scene is read from. */
  std::unique_ptr<ResultDirectory> open(const std::filesystem::path &directory);
  /**
   * Read the packing; if a drawing is refused, write what shows its faults
   * beside earlier results.
   */
  Packing<2> read_packing(const std::filesystem::path &directory,
                          ResultDirectory *files);

  const ProcessGroup processes;
  /** The wall clock times of the stages. */
  dealii::TimerOutput timer;
  /** The scene and the question about it. */
  SceneAnalysis analysis;
  /** What is done with the answer. */
  ResultWriter writer;
};
} // namespace Voussoir

#endif
