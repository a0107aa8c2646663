// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_model_cells_h
#define voussoir_packing_polyhedra_models_model_cells_h

#include <voussoir/packing/polyhedra/cell_faces.h>
#include <voussoir/packing/polyhedra/models/block_mesh.h>
#include <voussoir/packing/polyhedra/models/model_defects.h>
#include <voussoir/packing/polyhedra/models/model_options.h>

#include <vector>

namespace Voussoir
{
/** The cells of a model, and what was wrong with it. */
struct ModelCells
{
  /** With a tolerance, and notices on the defects. */
  CellFaces cells;
  /** All that was mended, by cells. */
  std::vector<ModelDefect> defects;
};

/**
 * Make cells of blocks: the parts of each block become cells, in the order of
 * the file, but fixed ones at the end. Their surfaces are mended, see
 * mend_surface.h, and no vertex is moved. What is in one part is in no other:
 * cells have vertices of their own.
 *
 * The size of a block is the cube root of the mean volume of blocks. The
 * tolerance is 1e-2 of it by default, which is what files of meshes are rounded
 * to and built with, or 1e-9 if the file was computed; and 16 units of rounding
 * of the largest coordinate, if that is more. Faces in one plane within a tenth
 * of the tolerance are joined. Vertices are welded within 1e-6 of the box of
 * their block or, if that leaves it open, within the tolerance.
 *
 * @throws InputError that names all blocks that cannot be used, or if the scale
 *   is not positive, or the tolerance below the rounding of the coordinates.
 */
ModelCells cells_of_model(const BlockMeshes &meshes,
                          const ModelOptions &options);
} // namespace Voussoir

#endif
