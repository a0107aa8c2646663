// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_models_check_surface_h
#define voussoir_packing_polyhedra_models_check_surface_h

#include <voussoir/packing/polyhedra/models/mend_surface.h>

namespace Voussoir
{
/**
 * Find faces without an area, that cross or touch themselves, that are off
 * their plane by more than @p distance, or are so far off that they have none.
 */
void check_faces(MendedSurface &mended, double distance);

/**
 * Find faces that cross or touch themselves, or are in no plane: what can be
 * told of a surface that is not closed.
 */
void check_shapes_of_faces(MendedSurface &mended);

/**
 * Find faces that cross others of the same surface in a segment that is longer
 * than @p distance; neighbours also farther than that from their sides. The
 * faces are cut into triangles, and of two with a common vertex only those that
 * look to opposite sides count.
 */
void check_crossings(MendedSurface &mended, double distance);
} // namespace Voussoir

#endif
