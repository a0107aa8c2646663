// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_space_clamping_h
#define voussoir_output_fields_space_clamping_h

#include <voussoir/output/fields/field.h>
#include <voussoir/output/space_results.h>

namespace Voussoir
{
// The proofs of whether blocks in space are clamped.

/** Of interfaces: the normal forces that balance by themselves. */
Fields<SpaceResults> face_self_stress();
/** Of cells: the motion that opens every interface. */
Fields<SpaceResults> opening_motion();
} // namespace Voussoir

#endif
