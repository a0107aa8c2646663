// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_block_parts_h
#define voussoir_packing_polyhedra_models_block_parts_h

#include <voussoir/packing/polyhedra/models/block_mesh.h>

#include <vector>

namespace Voussoir
{
/**
 * The parts of a block, each by the numbers of its faces: surfaces that have no
 * edge in common, if these are closed. For the rest vertices at one place are
 * one, as in a list of triangles; where surfaces then have edges in common,
 * since blocks touch, a part ends where its surface closes, in the order of the
 * file. What closes nowhere is one part.
 */
std::vector<std::vector<unsigned int>> parts_of(const BlockMesh &block);

/** True if all faces are connected by edges. */
bool is_connected(const FaceLoops &faces);
} // namespace Voussoir

#endif
