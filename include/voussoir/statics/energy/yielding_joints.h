// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_yielding_joints_h
#define voussoir_statics_energy_yielding_joints_h

#include <voussoir/statics/energy/elastic_problem.h>

#include <vector>

namespace Voussoir
{
/**
 * Minimise the energy of elastic joints that bear tension or crush, with
 * Tresca's friction, which yield at their limits without hardening; see
 * YieldingJoint.
 *
 * Bent, joints that crush between blocks that turn have the energy of a stress
 * that is linear along the joint, three times that of the two forces at the
 * ends that other joints have. Newton's method may get stuck, as it does beyond
 * the limit load. Then find_state_or_collapse() says whether there is a state,
 * which is not one of least energy, and says so in Solution::selection.
 *
 * @param problem without coefficients of friction.
 * @param order the controls.
 * @param start n_dofs() numbers to start from; empty for zero.
 * @param terminal sees the iterations.
 */
Solution minimise_yielding(const DiscreteProblem &problem,
                           const ElasticOrder &order,
                           std::vector<double> start,
                           Terminal &terminal);
} // namespace Voussoir

#endif
