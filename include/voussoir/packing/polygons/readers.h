// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_readers_h
#define voussoir_packing_polygons_readers_h

#include <voussoir/packing/polygons/layer_choice.h>
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
 * Rings whose last vertex is not the first one stay open; see close_rings().
 *
 * @throws InputError naming the line and the cell if a line is anything else,
 *   a polygon has a hole, or the file has no polygon.
 */
PolygonList read_wkt_file(const std::filesystem::path &file);

/**
 * Read the faces of an OFF file (Geomview's object file format) as text, by
 * CGAL. Each face is a cell; z is ignored, with a notice unless all are zero,
 * and so are colours and normals.
 *
 * @throws InputError naming the line if the file cannot be read, is no OFF
 *   file, or has no face.
 */
PolygonList read_off_file(const std::filesystem::path &file);

/**
 * Read polygons from whatever GDAL/OGR reads: DXF, GeoJSON, GeoPackage,
 * Shapefile, CSV with a column WKT, and others.
 *
 * A feature that is a polygon or a line gives one cell, one of several polygons
 * gives as many; lines that are not closed stay open, see close_rings(). Its
 * group is the value of the field "group", or else "name", or else "Layer",
 * which is the layer of a DXF file, unless @p layers names another. Features
 * are counted from one in the order of the file, over all its layers. Features
 * that bound no area, such as points and texts, are left out with a notice; Z
 * is ignored with one. Arcs are bulges, and other curves become chains of sides
 * with a notice.
 *
 * @param layers that are read.
 * @throws InputError naming the feature and the cell if the file cannot be
 *   read, a polygon has a hole, there is no polygon, or @p layers names one
 *   that is not there; and for every file if Voussoir was built without GDAL.
 */
PolygonList read_ogr_file(const std::filesystem::path &file,
                          const LayerChoice &layers);
} // namespace Voussoir

#endif
