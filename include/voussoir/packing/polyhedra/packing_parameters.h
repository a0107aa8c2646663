// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_packing_parameters_h
#define voussoir_packing_polyhedra_packing_parameters_h

#include <voussoir/packing/generators/generator_choice.h>
#include <voussoir/packing/packing_parameters.h>
#include <voussoir/packing/polyhedra/models/model.h>
#include <voussoir/packing/polyhedra/packing.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** The section `Packing` in space. */
template <>
class PackingParameters<3>
{
public:
  /** With all generators, each with the defaults of its parameters. */
  PackingParameters();

  /** Declare the section, with those of the generators, and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /** ModelGenerator::give(); it is used if that is the generator chosen. */
  void give(BlockMeshes given) { models->give(std::move(given)); }

  /** The files that make_packing() reads. */
  std::vector<std::filesystem::path>
  input_files(const std::filesystem::path &directory) const
  {
    return generators.chosen().input_files(directory);
  }

  /**
   * The packing that the parameters describe, with the groups of the entry
   * `Groups`; only what a file marks is fixed.
   *
   * @param directory the start of relative paths among the parameters.
   * @param joins_edges see ContactTolerance; of models, for blocks that turn.
   * @param terminal see PackingGenerator::generate().
   * @throws InputError if the parameters describe no packing: as
   *   PackingGenerator::generate(), Packing::Packing() and assign_groups() do.
   */
  Packing<3> make_packing(const std::filesystem::path &directory,
                          bool joins_edges,
                          Terminal &terminal) const;

private:
  GeneratorChoice<3> generators;
  ModelGenerator *models; // one of them
  std::string groups;
};
} // namespace Voussoir

#endif
