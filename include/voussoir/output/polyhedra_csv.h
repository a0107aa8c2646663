// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_polyhedra_csv_h
#define voussoir_output_polyhedra_csv_h

#include <voussoir/output/space_results.h>

#include <iosfwd>
#include <string>

namespace Voussoir
{
// The tables of blocks in space, in files of the names that csv.h has.

/** One line per interface, in their order, with face_interface_fields(). */
void write_interfaces_csv(std::ostream &out, const SpaceResults &answer);

/** One line per boundary face, with boundary_face_fields(). */
void write_boundary_csv(std::ostream &out, const SpaceResults &answer);

/** One line per cell, then one per fixed cell, with polyhedron_fields(). */
void write_cells_csv(std::ostream &out, const SpaceResults &answer);

/** The name of the table of the points of interfaces. */
inline const std::string interface_points_csv = "interface_points.csv";

/**
 * One line per point of an interface at which a force acts, FacePoints: the
 * number of the interface, 1 if the point bears pressure and 0 if it bears
 * friction alone, its share of the area, the place (L), and if there are forces
 * that on c- (S L^2).
 */
void write_interface_points_csv(std::ostream &out, const SpaceResults &answer);
} // namespace Voussoir

#endif
