// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_polyhedra_h
#define voussoir_output_fields_polyhedra_h

#include <voussoir/output/fields/field_table.h>
#include <voussoir/output/space_results.h>
#include <voussoir/packing/polyhedra/packing.h>

namespace Voussoir
{
// All quantities in space, in explicit lists.

/** The quantities of all polyhedra, fixed cells included. */
const FieldTable<SpaceResults> &polyhedron_fields();
/** The quantities of interfaces. */
const FieldTable<SpaceResults> &face_interface_fields();
/** The quantities of polyhedra that a packing alone has. */
const FieldTable<Packing<3>> &packing_polyhedron_fields();
/** The quantities of interfaces that a packing alone has. */
const FieldTable<Packing<3>> &packing_face_fields();
/** The quantities of boundary faces. */
const FieldTable<SpaceResults> &boundary_face_fields();
} // namespace Voussoir

#endif
