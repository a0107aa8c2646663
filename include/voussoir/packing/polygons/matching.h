// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_matching_h
#define voussoir_packing_polygons_matching_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/polygon_list.h>

namespace Voussoir
{
/**
 * Find where polygons touch, and give those that do the vertices in common.
 *
 * Vertices nearer to each other than the tolerance are one vertex, which stays
 * where the first of them in the file is. A vertex nearer than the tolerance to
 * the side of another polygon is inserted into that side: a T-junction, or the
 * end of a partial contact. So a side moves by up to twice the tolerance, and
 * sides of two cells coincide where they are no further apart than the
 * tolerance; wider gaps stay open. A side shorter than the tolerance vanishes.
 *
 * A notice tells of the largest move, if it is more than rounding.
 *
 * The distances are those of the polygons as given, found with an R-tree.
 *
 * @param polygons as check_and_orient() leaves them, no two of which overlap
 *   more deeply than the tolerance.
 * @param tolerance a length that passes check_tolerance().
 * @throws InputError naming the cell and the place if one is too small or
 *   narrow for the tolerance, or moves by more than a thousandth of the mean
 *   size of a cell.
 */
CellLoops match_polygons(PolygonList &polygons, double tolerance);
} // namespace Voussoir

#endif
