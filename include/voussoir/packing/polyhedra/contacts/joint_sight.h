// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_joint_sight_h
#define voussoir_packing_polyhedra_contacts_joint_sight_h

#include <voussoir/packing/polyhedra/contacts/face_pair.h>

namespace Voussoir
{
/**
 * The parts of an open joint between two faces that nothing covers: neither a
 * third cell nor another face of the two lies between them. What is left beside
 * that and is narrower than the joint is wide is none: there the two see each
 * other through the joint between their neighbours.
 *
 * @param ring the joint, in the coordinates of the pair.
 */
ConvexRings parts_in_sight(const FaceGeometry &geometry,
                           const FacePair &pair,
                           const ConvexRing &ring);
} // namespace Voussoir

#endif
