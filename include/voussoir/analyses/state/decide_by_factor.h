// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_state_decide_by_factor_h
#define voussoir_analyses_state_decide_by_factor_h

#include <voussoir/statics/problem/discrete_problem.h>
#include <voussoir/statics/problem/solution.h>
#include <voussoir/terminal/terminal.h>

#include <optional>

namespace Voussoir
{
/**
 * Decide whether the loads of a scene are carried by the greatest factor by
 * which they all may be multiplied, see find_load_factor(): close to the limit,
 * where a search with the loads as they are finds neither forces nor a
 * mechanism, the factor is free to be a little less or more than one. Forces at
 * a greater factor, divided by it, carry the loads, since joints without forces
 * are within their limits; a mechanism that bounds it by less than one is their
 * collapse. Of dry joints all factors are carried or none but zero: there it
 * seldom decides.
 *
 * @param scene with loads.
 * @param problem that of the scene.
 * @param n_max_iterations after which to give up.
 * @param terminal sees the iterations.
 * @return forces or a mechanism; nothing if one is between the two bounds.
 */
std::optional<Solution> decide_by_factor(const Scene &scene,
                                         const DiscreteProblem &problem,
                                         unsigned int n_max_iterations,
                                         Terminal &terminal);
} // namespace Voussoir

#endif
