// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_joint_checks_h
#define voussoir_packing_polygons_joint_checks_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/polygon_list.h>

namespace Voussoir
{
/**
 * Refuse a joint width that is a large share of a block, which is a slip of the
 * unit: at most two thirds of the mean size, the root of the area.
 *
 * Joints of 30 beside bricks of 50 x 50 have 0.6 of that; of 10 in a brick
 * wall, 0.09; as wide as the bricks are thick, as in Byzantine walls, 0.6. The
 * thickness itself would refuse these, and any joint beside a slate. A width in
 * millimetres for metres has 100, one in inches for metres 3, and openings as
 * large as a block 1: these would be joined.
 *
 * @param scale what the coordinates of the file were multiplied by.
 * @throws InputError naming the width, a block, and, if it fits, the width that
 *   was meant if it was given in the unit of the file.
 */
void check_joint_width(const PolygonList &polygons,
                       double joint_width,
                       double scale);

/**
 * Find joints that cannot be: one whose strip, from side to side, crosses a
 * block or another joint more deeply than the tolerance, or is wider all along
 * than both its blocks are large, so that there is room for another block.
 *
 * @param cells with CellLoops::facing, of the polygons in their order.
 */
void check_joints(PolygonList &polygons,
                  const CellLoops &cells,
                  double tolerance);
} // namespace Voussoir

#endif
