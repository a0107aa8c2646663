// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_forces_h
#define voussoir_output_fields_forces_h

#include <voussoir/output/fields/field.h>
#include <voussoir/output/results.h>

namespace Voussoir
{
/** f_e^n and f_e^t, and in grids the vector of both, and both as stresses. */
Fields<Results> interface_forces();
/** Where blocks turn, the part of f_e^n at each end, and its place. */
Fields<Results> forces_at_ends();
/** What the analytic centre tells of the forces of all states. */
Fields<Results> marks_of_all_states();
} // namespace Voussoir

#endif
