// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_opening_h
#define voussoir_statics_opening_h

#include <vector>

namespace Voussoir
{
/**
 * The proof that a motion opens every joint, or that none does. By the theorem
 * of the alternative of Gordan exactly one of these exists:
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
  /** u, n_dofs() numbers; see opening_of(). */
  std::vector<double> displacement;
  /**
   * Of each row of each joint, of any size: normal forces p that balance by
   * themselves.
   */
  std::vector<double> self_stress;
};
} // namespace Voussoir

#endif
