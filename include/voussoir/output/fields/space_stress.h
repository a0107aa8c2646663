// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_space_stress_h
#define voussoir_output_fields_space_stress_h

#include <voussoir/output/fields/field.h>
#include <voussoir/output/space_results.h>

namespace Voussoir
{
/** Of cells: the stress inside. */
Fields<SpaceResults> polyhedron_stress();
} // namespace Voussoir

#endif
