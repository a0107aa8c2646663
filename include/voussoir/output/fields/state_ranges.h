// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_state_ranges_h
#define voussoir_output_fields_state_ranges_h

#include <voussoir/output/fields/field.h>
#include <voussoir/output/results.h>

namespace Voussoir
{
/** How much the forces of each interface differ among all states. */
Fields<Results> state_ranges();
/** What the forces of each interface are in samples of all states. */
Fields<Results> sample_moments();
} // namespace Voussoir

#endif
