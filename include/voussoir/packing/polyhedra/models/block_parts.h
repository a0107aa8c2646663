// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_block_parts_h
#define voussoir_packing_polyhedra_models_block_parts_h

#include <voussoir/packing/polyhedra/models/block_mesh.h>

#include <vector>

namespace Voussoir
{
/**
 * The parts of a block, each by the numbers of its faces: surfaces that have no
 * vertex in common, if these are closed. Else vertices at one and the same
 * place are one, as in a list of triangles; where surfaces then have edges in
 * common, since blocks touch, a part ends where its surface closes, in the
 * order of the file. What does so nowhere stays together.
 */
std::vector<std::vector<unsigned int>> parts_of(const BlockMesh &block);
} // namespace Voussoir

#endif
