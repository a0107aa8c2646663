// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_barrier_problem_h
#define voussoir_statics_energy_barrier_problem_h

#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/statics/energy/barrier_joint.h>
#include <voussoir/statics/problem/shared_problem.h>
#include <voussoir/terminal/terminal.h>

#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * The multiple of the problem's opening that has the least energy. Where the
 * load does not resist it any will do.
 */
std::vector<double> start_of_barrier(const SharedProblem &problem,
                                     const BarrierJoint &law);

/**
 * Minimise the energy of BarrierJoint by Newton's method; collective.
 *
 * @param problem shares out and collects.
 * @param law of its joints.
 * @param system solves the linear systems.
 * @param tolerance the largest imbalance to stop at.
 * @param n_max_iterations after which to give up.
 * @param terminal sees the iterations.
 * @throws SolverError if a linear system cannot be solved.
 */
Solution minimise_barrier(const SharedProblem &problem,
                          const BarrierJoint &law,
                          JointSystem &system,
                          double tolerance,
                          unsigned int n_max_iterations,
                          Terminal &terminal);

} // namespace Voussoir

#endif
