// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_off_file_h
#define voussoir_packing_polygons_off_file_h

#include <voussoir/packing/polygons/polygon_list.h>

namespace Voussoir
{
/**
 * Read the faces of an OFF file (Geomview's object file format) as text, by
 * CGAL. Each face is a cell; z is ignored, with a notice unless all are zero,
 * and so are colours and normals.
 *
 * @throws InputError naming the line if the file cannot be read, is no OFF
 *   file, or has no face.
 */
PolygonList read_off_file(const std::filesystem::path &file);
} // namespace Voussoir

#endif
