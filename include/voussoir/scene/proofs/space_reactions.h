// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_space_reactions_h
#define voussoir_scene_proofs_space_reactions_h

#include <voussoir/scene/proofs/face_function.h>

#include <vector>

namespace Voussoir
{
/** Supports in one plane below cells that touch each other: a pier's foot. */
struct PlaneSupport
{
  /** The numbers of the interfaces, ascending. */
  std::vector<unsigned int> interfaces;
  /** Of their area; lengths. */
  dealii::Point<3> centroid;
  /** The unit normal from the packing to the ground. */
  dealii::Tensor<1, 3> normal;
  /** L^2. */
  double area = 0.;
};

/** All of them, in the order of x, y and z of their centroids. */
std::vector<PlaneSupport> plane_supports(const Packing<3> &packing);

/** The force of the ground on the packing along one support. */
struct SpaceReaction
{
  /** Where it is. */
  PlaneSupport support;
  /** On the packing; S L^2. */
  dealii::Tensor<1, 3> force;
  /** About the centroid; S L^3. */
  dealii::Tensor<1, 3> moment;
  /**
   * Where the resultant meets the plane, a length; the centroid if nothing
   * presses.
   */
  dealii::Point<3> place;
};

/** The reactions of all supports, in the user's units. */
std::vector<SpaceReaction> reactions(const Packing<3> &packing,
                                     const FaceForces &forces);

/** Component @p i of the force of the ground along a support. */
FaceFunction reaction(const PlaneSupport &support, unsigned int i);
} // namespace Voussoir

#endif
