// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_overlap_h
#define voussoir_packing_polygons_overlap_h

#include <voussoir/packing/polygons/polygon_list.h>

namespace Voussoir
{
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
} // namespace Voussoir

#endif
