// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_space_ranges_h
#define voussoir_output_fields_space_ranges_h

#include <voussoir/output/fields/field.h>
#include <voussoir/output/space_results.h>

namespace Voussoir
{
/** Of interfaces in space: their forces among all states. */
Fields<SpaceResults> face_ranges();
} // namespace Voussoir

#endif
