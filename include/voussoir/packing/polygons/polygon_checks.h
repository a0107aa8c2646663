// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_polygon_checks_h
#define voussoir_packing_polygons_polygon_checks_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/polygon_list.h>

namespace Voussoir
{
/**
 * Check that every ring is a simple polygon that could be a cell, by exact
 * predicates, and turn those that run clockwise.
 *
 * @throws InputError naming the cell, its record and the place if a vertex is
 *   not finite or repeated, there are fewer than three, the polygon has no
 *   area, crosses or touches itself, or is a sliver.
 */
void check_and_orient(PolygonList &polygons);

/** The root of the mean area of a cell; a length. */
double mean_size(const PolygonList &polygons);

/**
 * The matching tolerance for coordinates that are right to rounding; a length.
 * It is 1e-10 of the mean size of a cell, or 16 units of rounding of the
 * largest coordinate if that is more. A random Voronoi packing of a million
 * cells has a shortest edge of about 1e-7 of that size.
 */
double automatic_tolerance(const PolygonList &polygons);

/**
 * Check that the tolerance can be resolved by the coordinates, and that no cell
 * is so thin that its opposite sides could be taken for one another.
 *
 * @throws InputError naming the tolerance or the cell.
 */
void check_tolerance(const PolygonList &polygons, double tolerance);

/**
 * Check that no two polygons overlap more deeply than the tolerance, a length.
 * The depth of an overlap is the shortest displacement that ends it; between
 * convex polygons it is along the normal of a side of one of them (the theorem
 * of separating axes). Others are cut into convex ones first.
 *
 * @param polygons simple and counterclockwise.
 * @throws InputError naming both cells and the place.
 */
void refuse_overlaps(const PolygonList &polygons, double tolerance);

/**
 * A sentence on cells that face each other across a gap so narrow that they
 * were probably meant to touch: a thousandth of the mean size of a cell, or ten
 * times the tolerance if that is more. Such a gap is an open joint that carries
 * nothing, which is easily mistaken for a fault of the load.
 *
 * @param tolerance the matching tolerance; a length.
 * @return the number of such pairs, the first with its place, and what to do;
 *   empty if there is none.
 */
std::string describe_narrow_gaps(const CellLoops &cells, double tolerance);
} // namespace Voussoir

#endif
