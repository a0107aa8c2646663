// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_space_space_data_h
#define voussoir_output_report_space_space_data_h

#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/space/report_content.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * What the script of the page in space reads: a JSON object without the sign
 * "<", so that it can stand inside an element. Lists of numbers are base64 of
 * their bytes, little-endian:
 *
 *  - cells, fixed, joints: their numbers;
 *  - centre, scale: a place x, a length, is stored as (x - centre) / scale;
 *  - vertices: three float32 for each;
 *  - cell_faces, face_sizes, corners: uint32, the number of faces of each cell,
 *    of corners of each face, and the vertices of one face after the other;
 *  - cut_faces, cut_triangles: uint32, the faces that are not convex, and the
 *    vertices of two triangles less than each of them has corners;
 *  - volumes, centroids: float64, L^3 and lengths, of each cell;
 *  - names, groups: those of CellRecords, as texts and as uint32;
 *  - file, record_name, records: those of CellRecords, uint32 the last;
 *  - joint_cells, joint_sizes: uint32, two cells and the number of corners of
 *    each joint; joint_vertices: three float32 for each corner; joint_areas:
 *    float64, L^2;
 *  - motion: six float32 for each cell, the displacement of its centroid and
 * its angle, such that the largest displacement is a part of the packing; empty
 * if there is none; collapses: true if it is to be seen at once;
 *  - fields: of each its name and unit, whether it is one `of` "cells" or
 *    "joints", its values as float64, its colours, and uint8 with the number of
 *    the colour of each value, 255 where it is missing.
 *
 * @param cell_scales one for each of SpaceReport::cell_fields.
 * @param contact_scales one for each of SpaceReport::contact_fields.
 */
std::string space_data(const SpaceReport &report,
                       const std::vector<ColourScale> &cell_scales,
                       const std::vector<ColourScale> &contact_scales);
} // namespace Voussoir

#endif
