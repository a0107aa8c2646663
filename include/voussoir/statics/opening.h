// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_opening_h
#define voussoir_statics_opening_h

#include <voussoir/statics/discrete_problem.h>

#include <vector>

namespace Voussoir
{
/**
 * Find a displacement that opens every joint, n_dofs() numbers, or none if
 * there is none: see DiscreteProblem::opening(), which keeps it.
 *
 * Where the supports all face one way it is the uniform dilation, with the
 * ground drawn back. Else it is sought by Newton's method as a minimum of
 *
 *     sum_e k_e min([u]_e . n_e - d_e, 0)^2 / 2,
 *
 * which is zero if and only if every joint can open by d_e.
 */
std::vector<double> find_opening(const DiscreteProblem &problem);
} // namespace Voussoir

#endif
