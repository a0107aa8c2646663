// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_packing_parameters_h
#define voussoir_packing_packing_parameters_h

#include <voussoir/packing/generators/generator_choice.h>
#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/polygons.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
template <int dim>
class PackingParameters;

/** The section `Packing`: which generator makes the packing, and from what. */
template <>
class PackingParameters<2>
{
public:
  /** With all generators, each with the defaults of its parameters. */
  PackingParameters();

  /** Declare the section, with those of the generators, and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /** PolygonGenerator::give(); it is used if that is the generator chosen. */
  void give(PolygonList given) { polygons->give(std::move(given)); }

  /** The files that make_packing() reads. */
  std::vector<std::filesystem::path>
  input_files(const std::filesystem::path &directory) const
  {
    return generators.chosen().input_files(directory);
  }

  /**
   * The packing that the parameters describe, with the groups of the entry
   * `Groups`, and without supports.
   *
   * @param directory the start of relative paths among the parameters.
   * @param joins_corners see join_corners(); for blocks that turn.
   * @param terminal see PackingGenerator::generate().
   * @throws InputError if the parameters describe no packing: as
   *   PackingGenerator::generate(), Packing::Packing() and assign_groups() do.
   */
  Packing<2> make_packing(const std::filesystem::path &directory,
                          bool joins_corners,
                          Terminal &terminal) const;

private:
  GeneratorChoice<2> generators;
  PolygonGenerator *polygons; // one of them
  std::string groups;
};
} // namespace Voussoir

#endif
