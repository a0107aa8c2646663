// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_centroids_h
#define voussoir_packing_polyhedra_voronoi_centroids_h

#include <voussoir/packing/polyhedra/cell_faces.h>
#include <voussoir/packing/voronoi/cell_size.h>

#include <vector>

namespace Voussoir
{
/**
 * The centroids of convex cells for a density of h^-5, where h is the @p size:
 * exact if that is constant, else by the tetrahedra between the centre and
 * triangles of the faces, with four points in each that are exact for
 * polynomials of degree two; lengths.
 *
 * @param cells with centres inside; no cell is fixed.
 * @throws InputError naming the place if h is not finite and positive.
 */
std::vector<dealii::Point<3>> weighted_centroids(const CellFaces &cells,
                                                 const CellSize<3> &size);
} // namespace Voussoir

#endif
