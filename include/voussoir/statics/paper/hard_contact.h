// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_paper_hard_contact_h
#define voussoir_statics_paper_hard_contact_h

#include <voussoir/statics/paper/smoothed_joint.h>
#include <voussoir/statics/problem/solution.h>

#include <vector>

namespace Voussoir
{
/**
 * Go from where Ipopt has stopped, which is near a point of the central path,
 * to that point: Ipopt judges the product of each normal force and opening by
 * an absolute tolerance, which leaves the forces themselves few digits. Newton
 * steps double them.
 *
 * @param problem was solved.
 * @param friction of its joints, for hard contact.
 * @param mu the barrier parameter of that point, positive.
 * @param u Ipopt's displacement, n_dofs() numbers; replaced, as the forces are.
 * @param tolerance the largest imbalance that will do.
 * @param solution with Ipopt's forces. They are replaced, and it counts as
 *   converged, if the steps converge; else nothing is changed.
 */
void refine_hard_contact(const DiscreteProblem &problem,
                         const SmoothedJoint &friction,
                         double mu,
                         std::vector<double> &u,
                         double tolerance,
                         Solution &solution);
} // namespace Voussoir

#endif
