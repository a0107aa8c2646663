// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_sufficient_strengths_h
#define voussoir_statics_problem_sufficient_strengths_h

#include <voussoir/statics/problem/solution.h>
#include <voussoir/statics/problem/solver_controls.h>

#include <functional>

namespace Voussoir
{
/**
 * Whether the mechanism of a problem with other strengths in the plane is one
 * with those of @p problem, too: joints that are stronger hardly move in it, so
 * that what is dissipated is well below the work.
 *
 * @param found gets that work and dissipation.
 */
bool collapses_with(const DiscreteProblem &problem, Solution &found);

/**
 * Solve with all strengths above 100 units of stress lowered to that, which
 * loads seldom need; forces within lower strengths are within the given ones.
 * Strengths far above the loads cost digits: in the linear program friction is
 * the difference of two multipliers that sum up to the strength, and in the
 * centre the square of the strength multiplies the rounding of the coordinates.
 * If that has no answer, or one in which a lowered strength is used up
 * (always_sliding), then with the strengths as they are; a mechanism in which
 * stronger joints hardly slide is an answer.
 *
 * @param problem with its own strengths.
 * @param controls for both together.
 * @param solve is called once or twice, with a problem and controls.
 * @return the better of the answers, with the iterations of both.
 */
Solution solve_with_sufficient_strengths(
    const DiscreteProblem &problem,
    const SolverControls &controls,
    const std::function<Solution(const DiscreteProblem &,
                                 const SolverControls &)> &solve);
} // namespace Voussoir

#endif
