// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_narrow_gaps_h
#define voussoir_packing_polygons_narrow_gaps_h

#include <voussoir/packing/packing.h>

#include <string>

namespace Voussoir
{
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
