// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_corner_contacts_h
#define voussoir_packing_polygons_corner_contacts_h

#include <voussoir/packing/packing.h>

namespace Voussoir
{
/**
 * Give a joint to each corner of a cell that touches a free side of another in
 * a point: as good as without length, a millionth of the sides around, so that
 * nothing that divides by lengths needs to know. The corner is cut off by as
 * much, parallel to the side. A notice tells of it.
 *
 * Corners that meet corners have no normal, and get none; nor do those of two
 * cells at the same point of a side.
 */
void join_corners(CellLoops &cells);
} // namespace Voussoir

#endif
