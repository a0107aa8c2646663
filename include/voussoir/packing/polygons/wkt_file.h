// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_wkt_file_h
#define voussoir_packing_polygons_wkt_file_h

#include <voussoir/packing/polygons/polygon_list.h>

namespace Voussoir
{
/**
 * Read polygons in the notation of the Open Geospatial Consortium (OGC
 * 06-103r4, "well-known text"), one POLYGON or MULTIPOLYGON a line, as Shapely,
 * QGIS and PostGIS write them:
 *
 *     # a lintel on a pier
 *     POLYGON ((0 2, 3 2, 3 3, 0 3, 0 2));lintel
 *     SRID=0;MULTIPOLYGON Z (((1 0 7, 2 0 7, 2 2 7, 1 2 7, 1 0 7)))
 *
 * A MULTIPOLYGON gives one cell for each of its polygons. Behind the last
 * parenthesis may stand a semicolon, comma or tab and the name of the group of
 * the cells. Empty lines and lines that begin with # are skipped, and so are a
 * leading SRID and, with a notice, Z and M.
 *
 * The grammar is read by Boost.Geometry. It takes a missing ordinate for zero
 * and a superfluous one for the next vertex, so the ordinates are counted
 * before.
 *
 * @throws InputError naming the line and the cell if a line is anything else,
 *   a polygon has a hole or is not closed, or the file has no polygon.
 */
PolygonList read_wkt_file(const std::filesystem::path &file);
} // namespace Voussoir

#endif
