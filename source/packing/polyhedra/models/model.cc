// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/model.h>
#include <voussoir/packing/polyhedra/models/model_cells.h>
#include <voussoir/packing/polyhedra/models/readers.h>

#include <cmath>

namespace Voussoir
{
void ModelGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter(
      "File", file,
      "The file of the blocks, with a name that ends in " + model_endings +
          ". A relative path starts at the directory of the .prm file.",
      Anything());
  prm.add_parameter(
      "Scale", scale,
      "What all coordinates of the file are multiplied by as they are read: "
      "0.001 for a model in mm and loads with m. All other lengths, and those "
      "in messages, are the scaled ones.",
      Double());
  prm.add_parameter(
      "Tolerance", tolerance,
      "The distance of faces that touch, at most, over the size of a block, "
      "which is the cube root of the mean volume of blocks. Faces at an angle "
      "touch in the part that is as near, if it is a tenth of what they have "
      "in common. Faces of one block within a tenth of the tolerance of one "
      "plane are joined, and vertices within it are welded where a block is "
      "open otherwise; a block less than twice as thick is an error. 0: 1e-2, "
      "for models of meshes with a few decimals or faces that do not quite "
      "meet; 1e-9 for tessellations of Neper. A mesh that was computed to all "
      "digits may have less.",
      Double(0.));
  prm.add_parameter(
      "Supports from file", uses_supports,
      "Whether the blocks that the file calls supports are fixed.", Bool());
}

CellFaces ModelGenerator::generate(const std::filesystem::path &directory,
                                   Terminal &terminal) const
{
  if (file.empty() && !given)
    throw InputError("'Packing/Generator' is 'model', but 'Packing/model/File' "
                     "names no file.");
  if (!(scale > 0. && std::isfinite(scale)))
    throw InputError(text("'Packing/model/Scale' = '", scale,
                          "' must be a positive number: that which makes "
                          "lengths of the model those of the scene."));
  if (!std::isfinite(tolerance))
    throw InputError("'Packing/model/Tolerance' must be finite: a tolerance "
                     "over the size of a block.");
  terminal.progress("reading blocks");
  const BlockMeshes meshes =
      given ? *given : read_model((directory / file).lexically_normal());
  terminal.progress("mending blocks");
  return cells_of_model(meshes, {scale, tolerance, uses_supports}).cells;
}

std::vector<std::filesystem::path>
ModelGenerator::input_files(const std::filesystem::path &directory) const
{
  if (file.empty() || given)
    return {};
  return {directory / file};
}
} // namespace Voussoir
