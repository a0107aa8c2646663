// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_space_forces_h
#define voussoir_output_fields_space_forces_h

#include <voussoir/output/fields/field.h>
#include <voussoir/output/space_results.h>

namespace Voussoir
{
// The quantities in space that follow from forces and motions.

/** Of interfaces: the resultants of their forces, and what they use. */
Fields<SpaceResults> face_forces();
/** Of interfaces: the strengths that they have. */
Fields<SpaceResults> face_strengths();
/** Of interfaces: how they open and slide in a motion. */
Fields<SpaceResults> face_jumps();
/** Of cells: the loads on them, and fixed cells without. */
Fields<SpaceResults> polyhedron_loads();
/** Of cells: the live loads of which a mechanism bounds the factor. */
Fields<SpaceResults> polyhedron_live_loads();
/** Of boundary faces: what acts on them. */
Fields<SpaceResults> loads_on_faces();
/** Of cells: their motion. */
Fields<SpaceResults> polyhedron_motion();
} // namespace Voussoir

#endif
