// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_space_certificate_h
#define voussoir_scene_proofs_space_certificate_h

#include <voussoir/scene/proofs/certificate_measures.h>
#include <voussoir/scene/proofs/face_function.h>
#include <voussoir/scene/space/face_forces.h>
#include <voussoir/scene/space/space_motion.h>
#include <voussoir/scene/space/space_scene.h>

namespace Voussoir
{
// The proofs of certificate.h in space, by the same rules: from the scene and
// the forces or the motion alone, in the user's units.

/** Judge forces: the sums on each cell, moments, and each of the FacePoints. */
Certificate certify(const SpaceScene &scene, const FaceForces &forces);

/** Judge a motion of the cells, of any size and unit. */
MechanismCertificate certify_mechanism(const SpaceScene &scene,
                                       const SpaceMotion &motion);

/** bound_of_factor() in space. */
FactorBound bound_of_factor(const SpaceScene &dead,
                            const SpaceScene &live,
                            const SpaceMotion &motion);

/**
 * The same for interfaces that bear Tresca's friction or cohesion all over
 * them, and not only at the centroids of their cells: what they dissipate is
 *
 *     s |w| sum over sides of sgn(h) |h|^3 / 6 (t (1 + t^2)^(1/2) + asinh t),
 *
 * between the ends of each, with the distance h of the side from the point
 * about which the interface spins with w, and the place t |h| along it.
 */
FactorBound bound_of_continuous_faces(const SpaceScene &dead,
                                      const SpaceScene &live,
                                      const SpaceMotion &motion);

/**
 * The same for joints with the friction that the pressures of @p forces give
 * them, without dilatancy.
 */
FactorBound bound_with_own_strengths(const SpaceScene &dead,
                                     const SpaceScene &live,
                                     const FaceForces &forces,
                                     const SpaceMotion &motion);

/**
 * The bound of @p function that @p motion proves, as in the plane; the motion
 * is in the unit of the displacements of the function.
 */
ForceBound bound_of(const SpaceScene &scene,
                    const FaceFunction &function,
                    const SpaceMotion &motion);

/** What one interface does in a motion. */
struct FaceJump
{
  /** The displacement of c+ relative to c- at the centroid; of the motion. */
  dealii::Tensor<1, 3> at_centroid;
  /** The least opening at a vertex; negative where blocks interpenetrate. */
  double least_opening;
  /** The greatest opening at a vertex. */
  double greatest_opening;
  /** The largest size of a slip at a vertex. */
  double largest_slip;
};

/** The jumps of all interfaces. */
std::vector<FaceJump> jumps_of_faces(const SpaceBlocks &blocks,
                                     const SpaceMotion &motion);

/** The work of the loads; S L^2 times the unit of the motion. */
double work_of_loads(const SpaceScene &scene, const SpaceMotion &motion);

/**
 * The part of its strength that an interface uses: the size of its tangential
 * force over c_e |e| + mu_e N; one where it bears nothing and has to.
 */
double utilisation_of_face(const SpaceBlocks &blocks,
                           const FaceForces &forces,
                           unsigned int e);
} // namespace Voussoir

#endif
