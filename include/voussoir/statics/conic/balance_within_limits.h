// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_balance_within_limits_h
#define voussoir_statics_conic_balance_within_limits_h

#include <voussoir/statics/problem/discrete_problem.h>
#include <voussoir/terminal/terminal.h>

#include <vector>

namespace Voussoir
{
/**
 * Forces that balance the loads to rounding within their limits, near @p forces
 * that do so nearly: with strengths that are nearly those that their pressures
 * give, friction is beyond them by the change of the last pass. In the plane by
 * equilibrate(); in space, where limits are curved, by state_near() with a
 * small share of a state away from the limits.
 *
 * @param problem with the limits.
 * @param forces of each row of each joint.
 * @param terminal sees the iterations.
 * @return @p forces if none are found.
 */
std::vector<double> balance_within_limits(const DiscreteProblem &problem,
                                          const std::vector<double> &forces,
                                          Terminal &terminal);
} // namespace Voussoir

#endif
