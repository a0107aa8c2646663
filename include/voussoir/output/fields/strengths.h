// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_strengths_h
#define voussoir_output_fields_strengths_h

#include <voussoir/output/fields/field.h>
#include <voussoir/output/results.h>

namespace Voussoir
{
/** s_e. */
Fields<Scene> strengths();
/** The share of it that a state uses. */
Fields<Results> utilisations();
/** The limits that only some scenes have: mu_e, f_t and f_c. */
Fields<Scene> further_limits();
/** The share of f_c that a state uses. */
Fields<Results> crushing_utilisations();
} // namespace Voussoir

#endif
