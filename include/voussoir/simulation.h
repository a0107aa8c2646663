// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_simulation_h
#define voussoir_simulation_h

#include <voussoir/result_writer.h>
#include <voussoir/study.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <filesystem>
#include <set>
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

  /**
   * Declare all parameters, with load cases of these names, and bind them to
   * the parts of the simulation.
   */
  void add_parameters(dealii::ParameterHandler &prm,
                      const std::set<std::string> &load_cases = {});

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
  /**
   * Read the packing; if a drawing is refused, write what shows its faults
   * beside earlier results.
   */
  Packing read_packing(ResultDirectory &files,
                       const std::filesystem::path &directory);

  Terminal &terminal;
  const Team team;
  dealii::TimerOutput timer;
  Study study;
  ResultWriter writer;
};
} // namespace Voussoir

#endif
