// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_reactions_h
#define voussoir_scene_proofs_reactions_h

#include <voussoir/packing/straight_runs.h>
#include <voussoir/scene/scene.h>

#include <vector>

namespace Voussoir
{
/**
 * The supports along straight lines, from left to right; the numbers are among
 * the supports.
 */
std::vector<StraightRun> straight_supports(const Packing<2> &packing);

/** The force of the ground on the packing along one straight support. */
struct Reaction
{
  /** @{ */
  /** The ends of the support, counterclockwise around the packing; lengths. */
  dealii::Point<2> start;
  dealii::Point<2> end;
  /** @} */
  /** On the packing; S L. */
  dealii::Tensor<1, 2> force;
  /**
   * Where its resultant meets the line of the support, a length; the middle if
   * nothing presses.
   */
  dealii::Point<2> place;
};

/** The reactions of all supports, in the user's units. */
std::vector<Reaction> reactions(const Scene &scene,
                                const InterfaceForces &forces);

/** The sum of all loads and of all reactions, and how they agree. */
struct GroundBalance
{
  /** The sum of F_c over all cells; S L. */
  dealii::Tensor<1, 2> load;
  /** The sum of the forces of all supports, and of links to the ground, on the
   * packing; S L. */
  dealii::Tensor<1, 2> reaction;
  /** |load + reaction| over the sum of the sizes of the loads on the cells. */
  double imbalance;
};

/**
 * Compare the loads of @p scene with its @p reactions and the forces of its
 * links, InterfaceForces::in_links, if there are any.
 */
GroundBalance balance_on_ground(const Scene &scene,
                                const std::vector<Reaction> &reactions,
                                const std::vector<double> &in_links = {});
} // namespace Voussoir

#endif
