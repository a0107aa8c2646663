// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_crossing_pairs_h
#define voussoir_packing_polygons_crossing_pairs_h

#include <voussoir/packing/polygons/side_pairs.h>

#include <vector>

namespace Voussoir
{
/**
 * The parts of strips that are not crossed by a narrower one. Of the shortest
 * lines across two strips that cross each other, the longer one is no joint:
 * what is seen through the joint of two blocks is not joined through it, and
 * where two sides at an angle face a third, each has the part that is nearer
 * to it. So the parts depend on no order.
 *
 * Strips that cross at more than half a right angle and have the same width, to
 * the tolerance, are both left as they are; check_joints() refuses them.
 *
 * @param pairs those of SideTree::uncovered().
 * @param tolerance how deep strips may overlap, and the length of a part that
 *   vanishes; a length.
 */
std::vector<SidePair> without_crossings(const std::vector<SidePair> &pairs,
                                        double tolerance);
} // namespace Voussoir

#endif
