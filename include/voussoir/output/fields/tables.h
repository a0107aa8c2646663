// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_tables_h
#define voussoir_output_fields_tables_h

#include <voussoir/analyses/capacity/capacity_curve.h>
#include <voussoir/output/fields/field_table.h>
#include <voussoir/output/results.h>

namespace Voussoir
{
// All quantities that files, Python and the manual have, in explicit lists.

/** The quantities of interfaces.csv and interfaces.vtu. */
const FieldTable<Results> &interface_fields();
/** The quantities of cells.csv and blocks.vtu. */
const FieldTable<Results> &cell_fields();
/** The quantities of boundary.csv. */
const FieldTable<Scene> &boundary_fields();
/** The quantities of mechanism_joints.csv and mechanism_joints.vtu. */
const FieldTable<MovingScene> &mechanism_joint_fields();
/** The quantities of links.csv and links.vtu. */
const FieldTable<Results> &link_fields();
/** The quantities of mechanism_links.csv and mechanism_links.vtu. */
const FieldTable<MovingScene> &mechanism_link_fields();
/** The quantities of capacity.csv. */
const FieldTable<CapacityCurve> &capacity_fields();
/** The quantities of mechanism.csv and mechanism.vtu. */
const FieldTable<MovingScene> &mechanism_fields();
/** The quantities of interfaces that a packing alone has. */
const FieldTable<Packing<2>> &packing_interface_fields();
/** The quantities of cells that a packing alone has. */
const FieldTable<Packing<2>> &packing_cell_fields();
} // namespace Voussoir

#endif
