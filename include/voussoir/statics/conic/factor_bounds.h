// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_factor_bounds_h
#define voussoir_statics_conic_factor_bounds_h

#include <voussoir/statics/conic/self_dual.h>

#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * Forces strictly within their bounds that balance the loads at a factor: the
 * proof that this factor is carried (the static theorem of limit analysis).
 */
struct FactorState
{
  /** The forces, a number for each row. */
  std::vector<double> x;
  /** The factor of the live load. */
  double alpha;
  /**
   * The largest component of what is missing to a balance, over the largest of
   * the dead loads and of the live ones at the factor.
   */
  double residual;
};

/**
 * Correct a @p point of SelfDual to a state, with the factor free: forces near
 * their bounds hardly move.
 *
 * @param forces of the joints.
 * @param program of the forces.
 * @param point close to the optimum.
 * @param anchor a state far from the bounds, if there is one. A share of it
 *   keeps those of a point at the optimum a little away from theirs, without
 *   which rounding leaves no balance.
 * @param share of the anchor, and what the factor loses by it.
 */
FactorState state_near(ConicForces &forces,
                       const SelfDual::Program &program,
                       const SelfDual::Point &point,
                       const std::optional<FactorState> &anchor = {},
                       double share = 0.);

/** A motion near a mechanism that bounds a factor. */
struct FactorMotion
{
  /** The displacement, n_dofs() numbers. */
  std::vector<double> u;
  /** The multipliers of the slacks, within their cones: at a bound the opening
   * or the sliding, positive. */
  std::vector<double> z;
  /**
   * The largest closing of what has no other limit, over the largest component
   * of the displacement.
   */
  double closing;
};

/**
 * Correct a @p point of SelfDual to a mechanism, with the work sense of the
 * live loads, whose dissipation less the work of the dead loads is a bound of
 * the factor (the kinematic theorem): openings near zero hardly move.
 *
 * @param forces of the joints.
 * @param program of the forces.
 * @param point close to the optimum.
 * @param anchor a motion that opens all that it may, and does the same work, if
 *   there is one. A share of it keeps joints open that hardly are.
 * @param share of the anchor, and what the bound loses by it.
 */
FactorMotion mechanism_near(ConicForces &forces,
                            const SelfDual::Program &program,
                            const SelfDual::Point &point,
                            const std::optional<FactorMotion> &anchor = {},
                            double share = 0.);
} // namespace Voussoir

#endif
