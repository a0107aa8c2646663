// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_facing_sides_h
#define voussoir_packing_polygons_facing_sides_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/polygon_list.h>
#include <voussoir/packing/polygons/side_pairs.h>

namespace Voussoir
{
/**
 * Find where sides of polygons face each other across a joint, and cut the
 * sides there. No vertex moves: the blocks keep their shapes and areas.
 *
 * The joint of a facing_pair() lies on the line that halves the angle of the
 * two, midway between them; its length is what the projections of both on it
 * have in common, without the parts that are wider than the limit, that another
 * block covers (SideTree::uncovered()), or that a narrower joint crosses
 * (without_crossings()). Its forces act on that line, and each block feels them
 * through the part of its own side that is projected there. See
 * CellLoops::facing.
 *
 * Parts of a side that overlap within the tolerance end midway, unless most of
 * the shorter one overlaps: that vanishes.
 *
 * @param polygons as check_and_orient() leaves them, no two of which overlap
 *   more deeply than the tolerance.
 * @throws DrawingRefused naming the cells and the place if check_joints() finds
 *   joints that cannot be.
 */
CellLoops join_facing_sides(PolygonList &polygons, const FacingLimits &limits);
} // namespace Voussoir

#endif
