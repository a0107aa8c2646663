// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_analysis_run_h
#define voussoir_run_analysis_run_h

#include <voussoir/parallel/process_group.h>
#include <voussoir/run/result_writer.h>
#include <voussoir/run/run.h>
#include <voussoir/run/scene_analysis.h>
#include <voussoir/terminal/terminal.h>

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace Voussoir
{
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
  void give(PolygonList polygons)
  {
    take_given_blocks();
    analysis.give(std::move(polygons));
  }

  unsigned int dimension() const override { return 2; }
  unsigned int verbosity() const override { return writer.verbosity(); }
  std::vector<std::filesystem::path>
  input_files(const std::filesystem::path &directory) const override
  {
    return analysis.input_files(directory);
  }
  std::vector<std::filesystem::path> files_of_forces() const override;
  void validate(const std::filesystem::path &directory) const override;
  RunOutcome carry_out(const std::filesystem::path &directory,
                       bool writes,
                       PackingsOfRuns *packings = nullptr) override;

  /** @{ */
  /** @param directory that of the file of parameters, where paths begin. */
  /**
   * The packing with its supports, from those that are shared if they have it.
   *
   * @throws InputError.
   */
  std::shared_ptr<const Packing<2>>
  shared_packing(const std::filesystem::path &directory,
                 SharedPackings<Packing<2>> &packings) const;
  /**
   * Answer the question of the parameters, and write nothing.
   *
   * @throws InputError, SolverError.
   */
  RunResult answer(const std::filesystem::path &directory,
                   SharedPackings<Packing<2>> &packings);
  /**
   * Write what a run with the same parameters has found, as this one would.
   *
   * @throws InputError if that cannot be written.
   */
  void write(const std::filesystem::path &directory, RunResult &result);
  /** @} */
  /** Write the page of what a run with the same parameters has found. */
  void write_page(std::ostream &out, RunResult &result) const;

protected:
  void declare(const NamedSections &names) override;

private:
  /**
   * Answer the question.
   *
   * @param files for what shows the faults of a drawing, or null.
   * @param packings that are shared, or null.
   */
  RunResult find(const std::filesystem::path &directory,
                 ResultDirectory *files,
                 SharedPackings<Packing<2>> *packings);
  /** Write what was found; what ResultWriter::write() returns. */
  std::string write(ResultDirectory &files, RunResult &result);
  /** Where results go, with the files protected that the scene is read from. */
  std::unique_ptr<ResultDirectory> open(const std::filesystem::path &directory);
  /**
   * Read the packing; if a drawing is refused, write what shows its faults
   * beside earlier results.
   */
  Packing<2> read_packing(const std::filesystem::path &directory,
                          ResultDirectory *files);

  const ProcessGroup processes;
  /** The scene and the question about it. */
  SceneAnalysis analysis;
  /** What is done with the answer. */
  ResultWriter writer;
};
} // namespace Voussoir

#endif
