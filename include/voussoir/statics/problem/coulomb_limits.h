// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_coulomb_limits_h
#define voussoir_statics_problem_coulomb_limits_h

#include <voussoir/statics/problem/discrete_problem.h>

#include <vector>

namespace Voussoir
{
// Friction by its places: one for each joint, in space one for each set with
// friction, as DiscreteProblem::with_tresca() counts them.

/**
 * The strengths that @p forces, of each row of each joint, give to friction,
 * nondimensional: c_e |e| + mu_e p_e of a joint, in space mu_e p_k of a
 * pressure and c_e times the share of a disc. Tension takes from cohesion.
 */
std::vector<double> limits_of_coulomb(const DiscreteProblem &problem,
                                      const std::vector<double> &forces);

/** The sizes of the tangential @p forces there. */
std::vector<double> sizes_of_friction(const DiscreteProblem &problem,
                                      const std::vector<double> &forces);

/** @p forces without the tangential ones. */
std::vector<double> pressures_of(const DiscreteProblem &problem,
                                 const std::vector<double> &forces);

/** How far friction is beyond its limits, over the largest load or one. */
double excess_of_friction(const DiscreteProblem &problem,
                          const std::vector<double> &forces);
} // namespace Voussoir

#endif
