// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_paper_compliant_start_h
#define voussoir_statics_paper_compliant_start_h

#include <voussoir/statics/energy/energy_program.h>
#include <voussoir/statics/paper/smoothed_joint.h>
#include <voussoir/statics/problem/discrete_problem.h>
#include <voussoir/statics/problem/solver_controls.h>
#include <voussoir/terminal/terminal.h>

#include <optional>
#include <vector>

namespace Voussoir
{
/** Where to start from with compliant contact; see compliant_start(). */
struct CompliantStart
{
  /** n_dofs() numbers, nondimensional. */
  std::vector<double> displacement;
  /** The proof that there is none. */
  std::optional<Mechanism> mechanism;
  /** @{ */
  /** What it took; zero for one that was not found. */
  unsigned int n_iterations = 0, n_evaluations = 0;
  /** @} */
};

/** What the forces of each joint cost, with compliant contact. */
std::vector<JointCost> smoothed_costs(const DiscreteProblem &problem,
                                      const SmoothedJoint &law);

/**
 * The displacement of smoothed friction with compliant contact by a few of
 * Newton's steps, from zero, or where these do not balance the bodies from an
 * EnergyProgram. Their linear systems, inexact, take a fraction of the time of
 * Ipopt's (measured, 100,000 cells).
 *
 * @param problem the bodies, loads and joints.
 * @param law of the joints, with compliant contact.
 * @param controls the tolerance and the largest number of iterations.
 * @param terminal sees the iterations.
 */
CompliantStart compliant_start(const DiscreteProblem &problem,
                               const SmoothedJoint &law,
                               const SolverControls &controls,
                               Terminal &terminal);
} // namespace Voussoir

#endif
