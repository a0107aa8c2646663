// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_cell_moments_h
#define voussoir_packing_polyhedra_cell_moments_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/symmetric_tensor.h>

namespace Voussoir
{
/** What a polyhedron weighs at the density one. */
struct CellMoments
{
  /** Negative if the faces run clockwise as seen from outside; L^3. */
  double volume = 0.;
  /** Centroid; a length. */
  dealii::Point<3> centroid;
  /** The integral of (x - centroid) (x - centroid)^T; L^5. */
  dealii::SymmetricTensor<2, 3> second;
};

/**
 * The moments of a cell, convex or not, by the divergence theorem: the sum over
 * triangles of its faces of the tetrahedra to one of its vertices, so that a
 * distant origin cancels nothing.
 */
CellMoments moments_of(const CellFaces &cells, unsigned int cell);

/**
 * Pairs of vertex numbers of the edges of a cell that are not the side of two
 * of its faces, once in each direction; empty if the cell is closed.
 */
std::vector<std::array<unsigned int, 2>> open_edges(const CellFaces &cells,
                                                    unsigned int cell);

/** The box of all vertices of all faces, lengths; the origin without any. */
dealii::BoundingBox<3> box_of(const CellFaces &cells);
} // namespace Voussoir

#endif
