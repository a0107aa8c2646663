// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_find_opening_h
#define voussoir_statics_problem_find_opening_h

#include <voussoir/statics/problem/discrete_problem.h>

#include <optional>
#include <string>

namespace Voussoir
{
/**
 * The proof that a motion opens every joint of @p problem, in the plane, or
 * that none does: the strict interior of the contact constraints. Found when it
 * is first asked for, as opening_without_search(), or by Newton's method, which
 * looks for the minimum of
 *
 *     sum_e k_e min([u]_e . n_e - d_e, 0)^2 / 2,
 *
 * which is zero if every joint can open by d_e. If not, the forces of the
 * springs at the minimum are p. A step that opens every joint, however little,
 * is u as well.
 */
const Opening &opening_of(const DiscreteProblem &problem);

/**
 * The proof where it needs no search, in the plane and in space. If the
 * supports all face one way, or there are none, the motion is the uniform
 * dilation, with the ground drawn back; if there is a joint on every side of
 * every cell, an even pressure balances by itself.
 *
 * @return nothing if neither is so.
 */
std::optional<Opening> opening_without_search(const DiscreteProblem &problem);

/** For the user: what clamps a packing whose @p opening has no motion, or that
 * it is not known. */
std::string reason_of_no_opening(const Opening &opening, bool has_ground);
} // namespace Voussoir

#endif
