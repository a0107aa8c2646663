// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_equilibrate_h
#define voussoir_statics_problem_equilibrate_h

#include <voussoir/statics/problem/discrete_problem.h>

namespace Voussoir
{
/**
 * The distance from its limit, as a stress and nondimensional, at which a force
 * moves freely in equilibrate().
 */
constexpr double ample_slack = 0.1;

/**
 * The sum of the loads and of all forces on each body, n_dofs() numbers.
 *
 * @param forces of each row of each joint, nondimensional.
 */
std::vector<double> imbalance(const DiscreteProblem &problem,
                              const std::vector<double> &forces);

/**
 * Forces near @p forces (of each row of each joint, nondimensional) that
 * balance every cell and are admissible, both to rounding if that can be
 * reached: the forces are moved into their limits, and then by the smallest
 * correction df that balances,
 *
 *     minimise  sum_e (d_e/|e|) ((df_e^n)^2 / w_e^n + (df_e^t)^2 / w_e^t).
 *
 * A weight w is one far from the limit and falls with the distance from it: a
 * force close to its limit hardly moves, one at its limit not at all. That is
 * repeated while it helps; with Coulomb's friction also from forces a little
 * below their limits, which the correction may lower.
 *
 * @param ample the distance at which w is one; where all are that far, the
 *   system is one of Componentwise.
 * @return the best forces met, by the larger of imbalance and violation; those
 *   given, if none are better.
 */
std::vector<double> equilibrate(const DiscreteProblem &problem,
                                const std::vector<double> &forces,
                                double ample = ample_slack);
} // namespace Voussoir

#endif
