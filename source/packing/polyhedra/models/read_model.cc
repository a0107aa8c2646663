// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/packing/polyhedra/models/readers.h>

#include <boost/algorithm/string/case_conv.hpp>

namespace Voussoir
{
const std::string model_endings =
    ".obj, .off, .ply, .stl, .json (COMPAS) or .tess (Neper)";

BlockMeshes read_model(const std::filesystem::path &file)
{
  const std::string ending = boost::to_lower_copy(file.extension().string());
  if (ending == ".off")
    return read_off_model(file);
  if (ending == ".obj")
    return read_obj_model(file);
  if (ending == ".ply")
    return read_ply_model(file);
  if (ending == ".stl")
    return read_stl_model(file);
  if (ending == ".json")
    return read_compas_model(file);
  if (ending == ".tess")
    return read_tess_model(file);
  throw InputError("The file of blocks '" + file.string() +
                   "' should have a name that ends in " + model_endings +
                   "; export it in one of these formats.");
}
} // namespace Voussoir
