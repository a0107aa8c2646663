// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_simulation_h
#define voussoir_simulation_h

#include <voussoir/factor_search.h>
#include <voussoir/input/earlier_run.h>
#include <voussoir/output/result_directory.h>
#include <voussoir/output/results.h>
#include <voussoir/scene/range_parameters.h>
#include <voussoir/stress/reconstruction.h>
#include <voussoir/stress/stress_part.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <filesystem>
#include <optional>
#include <string>

namespace Voussoir
{
/**
 * One run, from the parameters to the files: packing, statics, stress, output.
 */
class Simulation
{
public:
  /** @param team the processes that help, beside this one, its root. */
  explicit Simulation(Terminal &terminal, const Team &team = Team());

  /** Declare all parameters and bind them to the parts of the simulation. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * Run the scene that the parameters describe and write its results.
   *
   * @param prm the parsed parameters, to be saved beside the results.
   * @param directory that of the .prm file, where relative paths begin.
   * @throws InputError, LoadNotCarried, SolverError.
   */
  void run(const dealii::ParameterHandler &prm,
           const std::filesystem::path &directory);

private:
  void add_output_parameters(dealii::ParameterHandler &prm);

  /** Kinds of results that are written. */
  enum class ResultFiles
  {
    all,
    csv,
    vtu,
    none
  };

  /** The form in which the packing is written, too. */
  enum class PackingFile
  {
    none,
    wkt,
    off
  };

  /** The forces of an earlier run, balanced to rounding if that is asked for.
   */
  Carried
  read_forces(EarlierRun &earlier, const Scene &scene, SolverRecord &record);
  RunRecord record_of(const Scene &scene) const;
  /** The settlement, if supports move, with its forces as the answer. */
  std::optional<Settlement>
  settle(Answer &answer, const Scene &scene, SolverRecord &record);
  /** The ranges of forces that are asked for, if any are. */
  std::optional<Ranges> ranges_of(const Scene &scene);
  /** The samples of all states that are asked for, if any are. */
  std::optional<StateSamples> samples_of(const Scene &scene);
  /** Look for a factor instead of a state, and write what is found. */
  void find_factor(ResultDirectory &files,
                   Given given,
                   const dealii::ParameterHandler &prm);
  /** True if results of that kind are to be written. */
  bool writes(ResultFiles kind) const;
  /**
   * Add to @p results what follows from the forces and is asked for.
   *
   * @return the root's part of the stress inside the cells, if there are more
   *   processes than one.
   */
  std::optional<StressPart> find_stresses(Results &results);
  /** Write the stress inside the cells. @return the name of the file. */
  std::string write_stress(ResultDirectory &files,
                           const Results &results,
                           const std::optional<StressPart> &own_part) const;
  /** Complete and write what was found. */
  void write(ResultDirectory &files,
             Results results,
             const dealii::ParameterHandler &prm);
  /** @throws LoadNotCarried when it is written. */
  [[noreturn]] void write(ResultDirectory &files,
                          Collapse collapse,
                          const dealii::ParameterHandler &prm);
  /** Write a motion of the blocks of @p scene; in the grid times @p factor. */
  void write_mechanism(ResultDirectory &files,
                       const Scene &scene,
                       const Motion &motion,
                       double factor) const;
  /** Add what every run writes, and put all files in place. */
  template <typename Found>
  void publish(ResultDirectory &files,
               Found &found,
               const dealii::ParameterHandler &prm);

  Terminal &terminal;
  const Team team;
  dealii::TimerOutput timer;
  std::string title;
  std::string output_directory = "output";
  /** Of results of which the forces are used; empty to solve. */
  std::string forces_from;
  /** What is asked of a scene. */
  enum class Analysis
  {
    state,
    load_factor
  };
  Analysis analysis = Analysis::state;
  unsigned int verbosity = 1;
  ResultFiles result_files = ResultFiles::all;
  PackingFile packing_file = PackingFile::none;
  SceneParameters of_scene;
  LoadFactorParameters load_factor;
  RangeParameters ranges;
  SolverParameters solver;
  StressParameters stress;
};
} // namespace Voussoir

#endif
