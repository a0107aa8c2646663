// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_opening_h
#define voussoir_statics_opening_h

#include <vector>

namespace Voussoir
{
class DiscreteProblem;

/**
 * Whether a motion opens every joint, with the proof. By the theorem of the
 * alternative of Gordan exactly one of these exists:
 *
 *     u with [u]_e . n_e > 0 for every e,
 *     p >= 0, not all zero, with sum_e p_e n_e = 0 on every cell (the sign of
 *     n_e outwards).
 *
 * Both are empty where the digits of the coordinates, from which n_e comes, do
 * not tell which one it is.
 */
struct Opening
{
  /** u, n_dofs() numbers; see DiscreteProblem::opening(). */
  std::vector<double> displacement;
  /** p_e of each joint, of any size: normal forces that balance by themselves.
   */
  std::vector<double> self_stress;
};

/**
 * Find out whether a motion opens every joint.
 *
 * Where the supports all face one way it is the uniform dilation, with the
 * ground drawn back. Else Newton's method looks for the minimum of
 *
 *     sum_e k_e min([u]_e . n_e - d_e, 0)^2 / 2,
 *
 * which is zero if every joint can open by d_e. If not, the forces of the
 * springs at the minimum are p. A step that opens every joint, however little,
 * is u as well.
 */
Opening find_opening(const DiscreteProblem &problem);

/**
 * Whether the displacement @p u (n_dofs() numbers) opens every joint by more
 * than the rounding of its normal, which is that of the coordinates over the
 * length of the joint, could make of it.
 */
bool opens_all_joints(const DiscreteProblem &problem,
                      const std::vector<double> &u);

/**
 * Whether no motion opens every joint by more than that, since the normal
 * forces @p p, one for each joint, balance by themselves: if every |u_c| <= 1,
 * then the least [u]_e . n_e is at most the sum of what is left on the cells
 * over the sum of p.
 */
bool is_self_stress(const DiscreteProblem &problem,
                    const std::vector<double> &p);
} // namespace Voussoir

#endif
