// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_block_places_h
#define voussoir_packing_polyhedra_models_block_places_h

#include <voussoir/packing/polyhedra/models/model_block.h>

#include <vector>

namespace Voussoir
{
/**
 * Find usable blocks with the centroid of one before them within @p tolerance,
 * a length, and its volume.
 */
void check_repeated_blocks(std::vector<ModelBlock> &blocks,
                           const CellRecords &records,
                           double tolerance);

/**
 * Find usable blocks of which all vertices are inside of another one, and the
 * box further inside of its box than @p tolerance, a length: such as the
 * surface around a hollow.
 */
void check_enclosed_blocks(std::vector<ModelBlock> &blocks,
                           const CellRecords &records,
                           double tolerance);
} // namespace Voussoir

#endif
