// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_ogr_file_h
#define voussoir_packing_polygons_ogr_file_h

#include <voussoir/packing/polygons/polygon_list.h>

namespace Voussoir
{
/**
 * Read polygons from whatever GDAL/OGR reads: DXF, GeoJSON, GeoPackage,
 * Shapefile, CSV with a column WKT, and others.
 *
 * A feature that is a polygon or a closed line gives one cell, one of several
 * polygons gives as many. Its group is the value of the field "group", or else
 * "name", or else "Layer", which is the layer of a DXF file. Features are
 * counted from one in the order of the file, over all its layers. Features that
 * bound no area, such as points and texts, are left out with a notice; Z is
 * ignored and curves become chains of sides, each with a notice.
 *
 * @throws InputError naming the feature and the cell if the file cannot be
 *   read, a line is not closed, a polygon has a hole, or there is no polygon;
 *   and for every file if Voussoir was built without GDAL.
 */
PolygonList read_ogr_file(const std::filesystem::path &file);
} // namespace Voussoir

#endif
