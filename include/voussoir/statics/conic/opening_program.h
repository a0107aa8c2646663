// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_opening_program_h
#define voussoir_statics_conic_opening_program_h

#include <voussoir/statics/problem/find_opening.h>
#include <voussoir/terminal/terminal.h>

namespace Voussoir
{
/**
 * The proof that a motion opens every joint of a problem in space, or that none
 * does, as opening_of() has it in the plane, by SelfDual. The pressures of
 *
 *     minimise    sum_k p_k^2 / (2 w_k k_e) - d_e p_k
 *     subject to  p >= 0, that balance by themselves,
 *
 * are zero if every joint can open by d_e, by which the displacement then does,
 * the multipliers of the balance; else they are a self-stress. k are the rows
 * of the joints, w_k their shares.
 *
 * @param problem in space, with joints that bear pressure alone.
 * @param terminal sees the iterations.
 * @return neither if rounding does not tell which it is.
 */
Opening find_opening_in_space(const DiscreteProblem &problem,
                              Terminal &terminal);
} // namespace Voussoir

#endif
