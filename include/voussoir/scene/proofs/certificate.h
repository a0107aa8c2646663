// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_certificate_h
#define voussoir_scene_proofs_certificate_h

#include <voussoir/scene/proofs/certificate_measures.h>
#include <voussoir/scene/scene.h>

namespace Voussoir
{
/**
 * Judge forces. Those that are not finite are infinitely wrong by all
 * measures.
 */
Certificate certify(const Scene &scene, const InterfaceForces &forces);

/** Judge a motion of the cells, of any size and unit. */
MechanismCertificate certify_mechanism(const Scene &scene,
                                       const Motion &motion);

/**
 * Bound the factor of the loads of @p live beside those of @p dead, a scene
 * with the same packing, by a motion of any size and unit: the kinematic
 * theorem of limit analysis.
 */
FactorBound
bound_of_factor(const Scene &dead, const Scene &live, const Motion &motion);
} // namespace Voussoir

#endif
