// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_face_triangles_h
#define voussoir_packing_polyhedra_face_triangles_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * True if a face has no corner that points inward by more than rounding, so
 * that the triangles from its first corner are inside it.
 */
bool is_convex_face(const CellFaces &cells, unsigned int face);

/**
 * The triangles of a face, by the numbers of their corners within it, from 0
 * on: two less than it has corners, which run about as it does. Faces that are
 * not convex are cut along diagonals; one that crosses itself is not cut, and
 * its triangles are those from its first corner.
 */
std::vector<std::array<unsigned int, 3>> triangles_of(const CellFaces &cells,
                                                      unsigned int face);
} // namespace Voussoir

#endif
