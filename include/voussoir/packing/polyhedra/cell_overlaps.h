// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_cell_overlaps_h
#define voussoir_packing_polyhedra_cell_overlaps_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <array>
#include <string>
#include <vector>

namespace Voussoir
{
/** Two cells that penetrate each other. */
struct CellOverlap
{
  /** The two, the lower number first. */
  std::array<unsigned int, 2> cells;
  /**
   * The shortest displacement that ends the overlap if both are convex; at most
   * that if they are not; a length.
   */
  double depth;
  /** A place that both have in common; a length. */
  dealii::Point<3> place;
};

/**
 * Find the pairs of cells that penetrate each other more deeply than the
 * tolerance, a length, ordered by the numbers of the cells. What is less than
 * the rounding of coordinates counts as that, see ContactTolerance. Two fixed
 * cells may overlap.
 *
 * Convex cells are compared along the normals of their faces and the common
 * normals of their edges (the theorem of separating axes). Where a cell is not
 * convex within the tolerance, points of each are looked for in the other: of
 * its edges, and of lines into it from the middle of its faces. The distance of
 * such a point from the surface of the other is no more than the depth, so that
 * two cells that do not overlap are never found, but those can be missed of
 * which none of these lines reaches far enough into the other.
 *
 * @throws InputError if the tolerance is negative or not finite, or as
 *   face_contacts() for coordinates and faces.
 */
std::vector<CellOverlap> overlaps(const CellFaces &cells, double tolerance);

/** Overlaps for tables and files, each as a defect of its first cell. */
std::vector<CellDefect> defects_of(const CellFaces &cells,
                                   const std::vector<CellOverlap> &overlaps);

/**
 * A sentence on some overlaps: how many there are, which is the deepest, and
 * what to do; empty if there are none.
 */
std::string describe_overlaps(const CellFaces &cells,
                              const std::vector<CellOverlap> &overlaps);
} // namespace Voussoir

#endif
