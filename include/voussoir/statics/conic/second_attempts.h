// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_second_attempts_h
#define voussoir_statics_conic_second_attempts_h

#include <voussoir/statics/conic/interior_point.h>
#include <voussoir/statics/problem/mechanism.h>
#include <voussoir/statics/problem/solution.h>
#include <voussoir/statics/problem/solver_controls.h>
#include <voussoir/terminal/terminal.h>

#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * Find the forces that cost the least, if another method has no answer.
 * Iterations add up.
 *
 * @param problem has the joints.
 * @param costs of each of them.
 * @param controls say when to stop; with the iterations before.
 * @param before what the other method has found.
 * @param terminal sees the iterations.
 * @return the forces and their displacement, or a mechanism, or if there is
 *   neither what there was before.
 */
Solution minimise_by_interior_point(const DiscreteProblem &problem,
                                    const std::vector<JointCost> &costs,
                                    const SolverControls &controls,
                                    const Solution &before,
                                    Terminal &terminal);

/** What the forces of each joint cost in the energy of ElasticJoint. */
std::vector<JointCost> elastic_costs(const DiscreteProblem &problem);

/**
 * Come close to the forces that cost the least.
 *
 * @param problem has the joints.
 * @param costs of each of them.
 * @param tolerance of the imbalance.
 * @param n_iterations the number of iterations that this has taken is added.
 * @param terminal sees the iterations.
 * @return the displacement, n_dofs() numbers; a mechanism if there is no
 *   minimum.
 */
std::vector<double> approach_minimum(const DiscreteProblem &problem,
                                     const std::vector<JointCost> &costs,
                                     double tolerance,
                                     unsigned int &n_iterations,
                                     Terminal &terminal);

/**
 * Look for a mechanism by way of the load factor, whose multipliers are the
 * critical one; for problems with an opening.
 */
std::optional<Mechanism>
find_collapse_by_load_factor(const DiscreteProblem &problem,
                             Terminal &terminal);

/**
 * Give a @p solution that has not converged a second chance. Close to the limit
 * of the load methods that only know displacements lose the digits in which
 * collapse differs from its opposite; these two do not (measured: settled to
 * 1e-8 of the limit). First the load factor, for a proof of collapse; then, if
 * there are @p costs, minimise_by_interior_point().
 */
Solution try_second_attempts(const DiscreteProblem &problem,
                             const std::vector<JointCost> &costs,
                             const SolverControls &controls,
                             Solution solution,
                             Terminal &terminal);
} // namespace Voussoir

#endif
