// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_cells_h
#define voussoir_output_fields_cells_h

#include <voussoir/output/fields/field.h>
#include <voussoir/output/results.h>

namespace Voussoir
{
/** The number and the centre of each cell. */
Fields<Packing<2>> cell_centres();
/** |c|. */
Fields<Packing<2>> cell_areas();
/** The group of each cell. */
Fields<Packing<2>> cell_groups();
/** F_c. */
Fields<Scene> cell_loads();
/** Where blocks turn, T_c. */
Fields<Scene> cell_load_torques();
/** The live loads of which a mechanism bounds the factor, and their torques. */
Fields<MovingScene> live_loads();
/** The torque of all forces, the mean stress and what follows from it. */
Fields<Results> cell_stresses();
} // namespace Voussoir

#endif
