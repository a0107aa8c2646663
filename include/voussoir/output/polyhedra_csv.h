// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_polyhedra_csv_h
#define voussoir_output_polyhedra_csv_h

#include <voussoir/packing/polyhedra/packing.h>

#include <iosfwd>

namespace Voussoir
{
// The tables of a packing in space, in files of the names that csv.h has.

/** One line per interface, in their order, with face_interface_fields(). */
void write_interfaces_csv(std::ostream &out, const Packing<3> &packing);

/** One line per boundary face, with boundary_face_fields(). */
void write_boundary_csv(std::ostream &out, const Packing<3> &packing);

/** One line per cell, then one per fixed cell, with polyhedron_fields(). */
void write_cells_csv(std::ostream &out, const Packing<3> &packing);
} // namespace Voussoir

#endif
