// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_find_opening_h
#define voussoir_statics_problem_find_opening_h

#include <voussoir/statics/problem/discrete_problem.h>

namespace Voussoir
{
/**
 * The proof that a motion opens every joint of @p problem, or that none does:
 * the strict interior of the contact constraints. Found when it is first asked
 * for.
 *
 * If the supports all face one way the motion is the uniform dilation, with the
 * ground drawn back. Else Newton's method looks for the minimum of
 *
 *     sum_e k_e min([u]_e . n_e - d_e, 0)^2 / 2,
 *
 * which is zero if every joint can open by d_e. If not, the forces of the
 * springs at the minimum are p. A step that opens every joint, however little,
 * is u as well.
 */
const Opening &opening_of(const DiscreteProblem &problem);
} // namespace Voussoir

#endif
