// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_facing_sides_h
#define voussoir_packing_polygons_facing_sides_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/polygon_list.h>

namespace Voussoir
{
/** What makes two sides face each other; see join_facing_sides(). */
struct FacingLimits
{
  /** The largest distance between them; a length. */
  double joint_width;
  /** The largest angle between their directions, below a right one; radians. */
  double angle;
  /** How deep they may overlap, and how short a joint vanishes; a length. */
  double tolerance;
};

/**
 * Find where sides of polygons face each other across a joint, and cut the
 * sides there. No vertex moves: the blocks keep their shapes and areas.
 *
 * Two sides face each other where their outward normals are opposite but for
 * the angle, and their distance is at most the width. The joint lies on the
 * line that halves their angle, midway between them; its length is what the
 * projections of both on it have in common, without the parts that are wider.
 * Its forces act on that line, and each block feels them through the part of
 * its own side that is projected there. See CellLoops::facing.
 *
 * At the corners of neighbours that follow a bent side, their parts may overlap
 * by less than half the joint width; then both end midway.
 *
 * @param polygons as check_and_orient() leaves them, no two of which overlap
 *   more deeply than the tolerance.
 * @throws InputError naming the cells and the place if a part of a side faces
 *   two other cells, one behind the other.
 */
CellLoops join_facing_sides(PolygonList &polygons, const FacingLimits &limits);
} // namespace Voussoir

#endif
