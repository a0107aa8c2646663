// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_model_h
#define voussoir_packing_polyhedra_models_model_h

#include <voussoir/packing/generators/generator.h>
#include <voussoir/packing/polyhedra/models/block_mesh.h>

#include <optional>
#include <string>
#include <utility>

namespace Voussoir
{
/**
 * Polyhedra that were drawn or computed by another program: each block of a
 * file, or each closed part of one, is a cell. See cells_of_model().
 */
class ModelGenerator : public PackingGenerator<3>
{
public:
  std::string name() const override { return "model"; }
  std::string meaning() const override { return "the blocks of a file."; }
  void add_parameters(dealii::ParameterHandler &prm) override;
  CellFaces generate(const std::filesystem::path &directory,
                     Terminal &terminal) const override;
  std::vector<std::filesystem::path>
  input_files(const std::filesystem::path &directory) const override;

  /** Take these blocks, and not those of the file. */
  void give(BlockMeshes blocks) { given = std::move(blocks); }

private:
  std::optional<BlockMeshes> given;
  std::string file;
  double scale = 1.;
  double tolerance = 0.;
  bool uses_supports = true;
};
} // namespace Voussoir

#endif
