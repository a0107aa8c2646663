// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_scene_analysis_h
#define voussoir_run_scene_analysis_h

#include <voussoir/analyses/analysis.h>
#include <voussoir/input/earlier_run.h>
#include <voussoir/output/results.h>
#include <voussoir/parallel/process_group.h>
#include <voussoir/scene/scene_parameters.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace Voussoir
{
/** What was found on a scene. */
struct RunResult
{
  /** The scene, which the others refer to. */
  std::unique_ptr<const Scene> scene;
  /** Forces that carry its loads, or the proof that there are none. */
  std::variant<Results, Collapse> found;

  /** What that says of the loads. */
  Status status() const
  {
    const auto *const carried = std::get_if<Results>(&found);
    return carried ? carried->status : Status{Status::Kind::collapse, 0.};
  }
};

/**
 * A scene, the question about it and how it is answered: all parameters but
 * those of the stress inside the blocks and of the output.
 */
class SceneAnalysis
{
public:
  /** @param processes the processes that help, beside this one, its root. */
  SceneAnalysis(Terminal &terminal,
                const ProcessGroup &processes,
                dealii::TimerOutput &timer);

  /** @{ */
  /** Declare the entries outside all sections, and the sections. */
  void add_entries(dealii::ParameterHandler &prm);
  void add_sections(dealii::ParameterHandler &prm, const NamedSections &names);
  /** @} */

  /** Keep what is found on the way in @p journal, or nothing if it is null. */
  void keep_in(Journal *journal) { solver.keep_in(journal); }
  /** Files that the scene is read from; paths start at @p directory. */
  auto input_files(const std::filesystem::path &directory) const
  {
    return of_scene.input_files(directory);
  }
  /** The entry `Forces from`: a directory, or empty. */
  const std::string &forces_from() const { return earlier_directory; }
  /** What the directory of an earlier run has, if forces are from there. */
  std::optional<EarlierRun> earlier_run() const;

  /** Take polygons as the packing; see PackingParameters::give(). */
  void give(PolygonList polygons) { of_scene.give(std::move(polygons)); }
  /** The packing with its supports; see PackingParameters::make_packing(). */
  Packing<2> read_packing(const std::filesystem::path &directory) const
  {
    return of_scene.read_packing(directory, terminal);
  }
  /** What the packing carries, and by what; the terminal shows the packing. */
  SceneData data(Packing<2> packing) const;

  /**
   * Show what was understood, and find what an answer would refuse of the scene
   * before it solves anything.
   *
   * @param data the scene.
   * @param units of it.
   * @throws InputError.
   */
  void show(SceneData data, const UnitNames &units) const;

  /**
   * Answer the question; the terminal shows what is doubtful about the answer.
   *
   * @param data the scene.
   * @param earlier where its forces are, if they are not to be found.
   * @throws InputError, SolverError.
   */
  RunResult answer(SceneData data, std::optional<EarlierRun> earlier) const;

private:
  /** The analysis that is asked for. */
  const Analysis &analysis() const { return *analyses[chosen]; }

  Terminal &terminal;
  const unsigned int n_processes;
  dealii::TimerOutput &timer;
  std::string earlier_directory;
  SceneParameters of_scene;
  SolverParameters solver;
  const FurtherAnalyses further;
  const std::vector<std::unique_ptr<Analysis>> analyses;
  unsigned int chosen = 0;
};
} // namespace Voussoir

#endif
