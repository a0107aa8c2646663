// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_model_block_h
#define voussoir_packing_polyhedra_models_model_block_h

#include <voussoir/packing/polyhedra/models/block_mesh.h>
#include <voussoir/packing/polyhedra/models/mend_surface.h>
#include <voussoir/packing/polyhedra/models/model_defects.h>
#include <voussoir/packing/polyhedra/models/model_options.h>

#include <vector>

namespace Voussoir
{
/** A block on its way to a cell. */
struct ModelBlock
{
  /** As it stands in the file, but scaled. */
  BlockMesh mesh;
  /** Its surface as far as it was mended. */
  MendedSurface mended;
  /** Of the surface, if it is usable. */
  SurfaceSums sums;

  /** True if it has a defect of a kind. */
  bool has(ModelDefect::Kind kind) const;
  /** True if its coordinates can be reckoned with. */
  bool has_numbers() const;
};

/**
 * The parts of all blocks, scaled, in the order of the file but with the fixed
 * ones at the end.
 */
std::vector<ModelBlock> model_blocks(BlockMeshes meshes,
                                     const ModelOptions &options);

/**
 * Weld the vertices of a block that are as far apart as numbers with seven
 * digits are, and orient its faces.
 */
void mend_block(ModelBlock &block);

/**
 * Weld a block that is open within the @p tolerance, a length; join its faces,
 * and check them and its thickness.
 */
void finish_block(ModelBlock &block, double tolerance);
} // namespace Voussoir

#endif
