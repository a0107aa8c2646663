// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_capacity_capacity_points_h
#define voussoir_analyses_capacity_capacity_points_h

#include <voussoir/scene/motion.h>

#include <deal.II/base/point.h>

#include <vector>

namespace Voussoir
{
/** What is asked of a capacity curve. */
struct CapacityWanted
{
  unsigned int cell;              /**< that has the point */
  dealii::Point<2> place;         /**< of the point at rest */
  dealii::Tensor<1, 2> direction; /**< of its displacement, a unit vector */
  unsigned int n_points;          /**< about so many */
  double largest;                 /**< displacement; L, zero for no limit */
  /**
   * How each support moves until the end of the curve, and the blocks with
   * them; empty where the ground is at rest, and blocks go along the mechanism
   * of the factor.
   */
  std::vector<SupportMotion> of_supports = {};
};

/** A point of the curve. */
struct CapacityPoint
{
  /** Of the point that is followed, in its direction; L. */
  double displacement;
  /** @{ */
  /** The factor there, between its proofs; see LoadFactor. */
  double carried, bound;
  /** @} */
  /** The largest Certificate::error() of the forces that carry it. */
  double error_of_state;
  /** Of the support that has gone farthest; L. */
  double of_supports = 0.;
  /** @{ */
  /**
   * The least force of the dead loads against the further displacement of the
   * supports, Settlement::work over the largest of it and negative, as a thrust
   * is; and what the motion proves to be the least. S L.
   */
  double support_force = 0., least_support_force = 0.;
  /** @} */
};
} // namespace Voussoir

#endif
