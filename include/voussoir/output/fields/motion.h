// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_motion_h
#define voussoir_output_fields_motion_h

#include <voussoir/output/fields/field.h>

#include <string>

namespace Voussoir
{
/** u_c of each cell. @param words what it is, which depends on the motion. */
Fields<Motion> cell_displacements(const std::string &words);
/** Where blocks turn, theta_c of each cell. */
Fields<Motion> cell_rotations();
/** The jumps at each interface, and what friction dissipates. */
Fields<MovingScene> interface_jumps();
} // namespace Voussoir

#endif
