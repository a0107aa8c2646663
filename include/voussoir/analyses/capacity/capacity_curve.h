// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_capacity_capacity_curve_h
#define voussoir_analyses_capacity_capacity_curve_h

#include <voussoir/analyses/capacity/capacity_points.h>
#include <voussoir/analyses/factors/load_factor.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The factor of the live loads while the blocks go along their mechanism, or
 * with supports that move, at displacements of any size.
 */
struct CapacityCurve
{
  /** From rest on, by ascending displacement. */
  std::vector<CapacityPoint> points;
  /** True if supports move. */
  bool has_moving_supports = false;
  /**
   * Where the factor is zero, or with supports that move where the dead loads
   * are carried last; not a number if the curve does not get there.
   */
  double ultimate;
  /** Why the curve ends, as the end of a sentence. */
  std::string end;
  /**
   * The share of the mass that takes part in the first mechanism,
   * (sum P_c d_c)^2 / (sum P_c sum P_c d_c^2), with the dead loads P_c and the
   * displacements d_c in the direction of the point; not a number with supports
   * that move.
   */
  double participation;
};

/** The curve with what was found at rest. */
struct CapacityAnswer
{
  /** At rest; without a factor there is no curve. */
  LoadFactorAnswer at_rest;
  CapacityCurve curve; /**< from there */
};

/**
 * Follow the mechanism of the greatest factor of the loads of @p live beside
 * those of @p dead, or the settlement of the dead loads where supports move. At
 * each position the ends of joints that the motion has opened are open, those
 * that it turns about and those that it leaves at rest touch exactly, and the
 * factor is found anew, with both proofs.
 *
 * @throws InputError if the point does not move in its direction, and as
 *   find_settlement().
 * @throws SolverError as find_load_factor() and find_settlement().
 */
CapacityAnswer find_capacity(const Scene &dead,
                             const Scene &live,
                             const CapacityWanted &wanted,
                             const LoadFactorControls &controls,
                             Terminal &terminal);
} // namespace Voussoir

#endif
