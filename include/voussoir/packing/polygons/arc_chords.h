// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_arc_chords_h
#define voussoir_packing_polygons_arc_chords_h

#include <voussoir/packing/polygons/polygon_list.h>

namespace Voussoir
{
/**
 * Replace all arcs by chords, so that nothing has bulges any more, with a
 * notice.
 *
 * An arc is cut where vertices of others lie on it, and each part has chords of
 * the same length: as few as are nowhere further from the arc than
 * @p deviation, and none that turns by more than a right angle. They are made
 * in one direction whichever way the arc was drawn, and once of arcs that are
 * the same, so that cells on both sides of an arc have the same vertices on it.
 *
 * @param deviation a length; 0: a thousandth of drawn_size().
 * @param tolerance how far apart the ends and middles of arcs that are the
 *   same, and vertices and arcs on which they lie, are at most; a length.
 * @throws InputError if @p deviation asks for more than 10,000 chords.
 */
void replace_arcs(PolygonList &polygons, double deviation, double tolerance);
} // namespace Voussoir

#endif
