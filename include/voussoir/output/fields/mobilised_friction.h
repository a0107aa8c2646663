// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_mobilised_friction_h
#define voussoir_output_fields_mobilised_friction_h

#include <voussoir/output/fields/field.h>
#include <voussoir/output/results.h>

namespace Voussoir
{
/** The angle of friction that the forces of an interface need. */
Fields<Results> mobilised_friction();
} // namespace Voussoir

#endif
