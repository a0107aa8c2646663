// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_simulation_h
#define voussoir_simulation_h

#include <voussoir/run_parameters.h>
#include <voussoir/terminal/terminal.h>

#include <filesystem>

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

  /** Read all parameters; see RunParameters::read(). */
  void read(const ParameterSources &sources) { parameters.read(sources); }
  /** All parameters with their values. */
  RunParameters &values() { return parameters; }

  /**
   * Read the scene that the parameters describe and show what was understood;
   * nothing is solved, and nothing written.
   *
   * @param directory that of the file of parameters, where relative paths
   *   begin.
   * @throws InputError.
   */
  void validate(const std::filesystem::path &directory);

  /**
   * Run the scene that the parameters describe and write its results, with the
   * parameters beside them.
   *
   * @param directory that of the file of parameters, where relative paths
   *   begin.
   * @throws InputError, LoadNotCarried, SolverError.
   */
  void run(const std::filesystem::path &directory);

private:
  /**
   * Read the packing; if a drawing is refused, write what shows its faults
   * beside earlier results.
   */
  Packing read_packing(ResultDirectory &files,
                       const std::filesystem::path &directory);

  Terminal &terminal;
  RunParameters parameters;
};
} // namespace Voussoir

#endif
