// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_space_run_h
#define voussoir_run_space_run_h

#include <voussoir/analyses/space_analysis.h>
#include <voussoir/packing/polyhedra/models/block_mesh.h>
#include <voussoir/run/output_entries.h>
#include <voussoir/run/run.h>
#include <voussoir/scene/space/space_scene_parameters.h>

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace Voussoir
{
/** What was found of blocks in space. */
struct SpaceResult
{
  SpaceResults answer;             /**< on the question of the parameters */
  std::vector<CellDefect> defects; /**< of the blocks */
};

/**
 * A run in space: the packing is made or read, checked and supported, what is
 * asked of it under its loads is answered, and both are written.
 */
class SpaceRun : public Run
{
public:
  /**
   * @param terminal sees what the run notices.
   * @param processes the processes that help, beside this one, its root.
   */
  explicit SpaceRun(Terminal &terminal,
                    const ProcessGroup &processes = ProcessGroup())
      : Run(terminal), processes(processes), analysis(processes)
  {}

  unsigned int dimension() const override { return 3; }
  unsigned int verbosity() const override { return output.verbosity; }
  std::vector<std::filesystem::path>
  input_files(const std::filesystem::path &directory) const override
  {
    return of_scene.input_files(directory);
  }
  void validate(const std::filesystem::path &directory) const override;
  RunOutcome carry_out(const std::filesystem::path &directory,
                       bool writes,
                       PackingsOfRuns *packings = nullptr) override;

  /** Take blocks as the packing; see PackingParameters::give(). */
  void give(BlockMeshes blocks)
  {
    take_given_blocks();
    of_scene.give(std::move(blocks));
  }
  /** @{ */
  /** @param directory that of the file of parameters, where paths begin. */
  /**
   * The packing with its supports, from those that are shared if they have it.
   *
   * @throws InputError.
   */
  std::shared_ptr<const CheckedPacking>
  shared_packing(const std::filesystem::path &directory,
                 SharedPackings<CheckedPacking> &packings) const;
  /**
   * Answer the question of the parameters, and write nothing.
   *
   * @throws InputError, SolverError.
   */
  SpaceResult answer(const std::filesystem::path &directory,
                     SharedPackings<CheckedPacking> &packings);
  /**
   * Write what a run with the same parameters has found, as this one would.
   *
   * @throws InputError if that cannot be written.
   */
  void write(const std::filesystem::path &directory, SpaceResult &result);
  /** @} */
  /** Write the page of what a run with the same parameters has found. */
  void write_page(std::ostream &out, const SpaceResult &result) const;

protected:
  void declare(const NamedSections &names) override;

private:
  /** The file in which the packing is written, too. */
  enum class PackingFile
  {
    none,
    off,
    obj,
    compas
  };

  /** What is computed of the stress inside. */
  enum class Accuracy
  {
    draft,
    standard,
    fine
  };

  /** Make the packing, check it, and show what was understood of a file. */
  CheckedPacking read_packing(const std::filesystem::path &directory) const;
  /** Answer the question; @p packings are shared, or null. */
  SpaceResult find(const std::filesystem::path &directory,
                   SharedPackings<CheckedPacking> *packings);
  /** The stress inside, as it is asked for. */
  void find_stress(SpaceResults &results) const;
  /** Where results go, with the files protected that the scene is read from. */
  std::unique_ptr<ResultDirectory> open(const std::filesystem::path &directory);
  void write(ResultDirectory &files, SpaceResult &result);
  void write_packing(ResultDirectory &files, const SpaceResults &answer) const;

  /** The times of this run so far, into what is written. */
  void keep_timings(SpaceResults &results);

  const ProcessGroup processes;
  OutputEntries output;
  SpaceSceneParameters of_scene;
  SpaceAnalysis analysis;
  Accuracy accuracy = Accuracy::fine;
  PackingFile packing_file = PackingFile::none;
  bool reports = true;
};
} // namespace Voussoir

#endif
