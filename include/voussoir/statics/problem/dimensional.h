// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_dimensional_h
#define voussoir_statics_problem_dimensional_h

#include <voussoir/scene/scene.h>
#include <voussoir/statics/problem/discrete_problem.h>
#include <voussoir/statics/problem/solution.h>

#include <vector>

namespace Voussoir
{
// What is found of a nondimensional problem, in the user's units and back.

/**
 * The motion of each of the n_cells() cells, without the ground: that of @p u
 * (n_dofs() numbers), times @p unit, with angles per the user's length. All at
 * rest if @p u is empty.
 */
Motion dimensional_motion(const DiscreteProblem &problem,
                          const std::vector<double> &u,
                          double unit);
/** The motion of Mechanism::u, of any size. */
Motion dimensional_motion(const DiscreteProblem &problem,
                          const Mechanism &mechanism);
/** The motion of Solution::u, in the user's unit. */
Motion dimensional_motion(const DiscreteProblem &problem,
                          const Solution &solution);

/** The displacement, n_dofs() numbers, of a motion; the ground is at rest. */
std::vector<double> nondimensional_motion(const DiscreteProblem &problem,
                                          const Motion &motion,
                                          double unit);

/**
 * The forces of @p solution in the units of the user, S L: times length_scale()
 * and stress_scale() of @p problem.
 */
InterfaceForces dimensional_forces(const DiscreteProblem &problem,
                                   const Solution &solution);
/** @{ */
/** The same by the names that a scene in space has, see discretise_space.h. */
inline Motion dimensional_motion(const DiscreteProblem &problem,
                                 const Scene & /*scene*/,
                                 const std::vector<double> &u,
                                 const double unit)
{
  return dimensional_motion(problem, u, unit);
}
inline InterfaceForces dimensional_forces(const DiscreteProblem &problem,
                                          const Scene & /*scene*/,
                                          const Solution &solution)
{
  return dimensional_forces(problem, solution);
}
/** @} */
/** Forces of each row, as in Solution::forces, of forces S L. */
std::vector<double> nondimensional_forces(const DiscreteProblem &problem,
                                          const InterfaceForces &forces);
} // namespace Voussoir

#endif
