// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_opening_proofs_h
#define voussoir_statics_problem_opening_proofs_h

#include <voussoir/statics/problem/discrete_problem.h>

#include <vector>

namespace Voussoir
{
// The two proofs of an Opening, beyond the rounding of the coordinates.

/**
 * True if the displacement @p u (n_dofs() numbers) opens every joint by more
 * than the rounding of its normal, which is that of the coordinates over the
 * size of the joint, could make of it.
 */
bool opens_all_joints(const DiscreteProblem &problem,
                      const std::vector<double> &u);

/**
 * True if no motion opens every joint by more than that, since the normal
 * forces @p p, of each row of each joint and zero in tangential ones, balance
 * by themselves: if every |u_c| <= 1, then the least [u]_e . n_e is at most the
 * sum of what is left on the cells over the sum of p.
 */
bool is_self_stress(const DiscreteProblem &problem,
                    const std::vector<double> &p);
} // namespace Voussoir

#endif
