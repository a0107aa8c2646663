// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_drawing_check_vtu_h
#define voussoir_output_vtu_drawing_check_vtu_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/drawing_faults.h>

#include <iosfwd>
#include <string>

namespace Voussoir
{
/** Its name. */
inline const std::string drawing_check_vtu = "drawing_check.vtu";

/**
 * Write a drawing with its faults: a polygon for each cell that can be drawn,
 * then what overlaps and gaps cover. Each polygon has the fields cell (-1 for
 * the latter), fault, the number of DrawingFault::Kind plus one or 0 for none,
 * and size, the depth of the overlap or the width of the gap.
 */
void write_drawing_check_vtu(std::ostream &out, const DrawingCheck &check);

/** The cells of a packing with the gaps that were left open. */
DrawingCheck check_of_gaps(const Packing<2> &packing);
} // namespace Voussoir

#endif
