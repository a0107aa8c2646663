// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_discretise_space_h
#define voussoir_statics_problem_discretise_space_h

#include <voussoir/scene/proofs/face_function.h>
#include <voussoir/scene/space/face_forces.h>
#include <voussoir/scene/space/space_motion.h>
#include <voussoir/scene/space/space_scene.h>
#include <voussoir/statics/problem/discrete_problem.h>
#include <voussoir/statics/problem/solution.h>

#include <vector>

namespace Voussoir
{
// From a scene in space to the nondimensional problem, and back, as in
// discretise.h.

/**
 * The problem of a scene in space: joints in the order of
 * Packing::interfaces(), bodies in that of the cells and at last the ground, if
 * there are supports.
 *
 * The rows of a joint are those of its FacePoints: of each of
 * FacePoints::pressure one along the normal, and with Coulomb's friction two
 * tangential ones in the same set; and of each of FacePoints::friction a set of
 * two tangential ones, if the joint has a strength without pressure.
 */
DiscreteProblem discretise(const SpaceScene &scene);

/** The loads of another scene with the same blocks, as discretise_loads(). */
std::vector<double> discretise_loads(const DiscreteProblem &problem,
                                     const SpaceScene &scene);

/**
 * A function of the forces in nondimensional variables: what the force of each
 * row of each joint is multiplied by.
 */
std::vector<double> discretise_function(const DiscreteProblem &problem,
                                        const SpaceScene &scene,
                                        const FaceFunction &function);

/**
 * The motion of each of the n_cells() cells, that of @p u (n_dofs() numbers)
 * times @p unit, with angles per the user's length.
 */
SpaceMotion dimensional_motion(const DiscreteProblem &problem,
                               const SpaceScene &scene,
                               const std::vector<double> &u,
                               double unit);

/** The forces of @p solution in the units of the user. */
FaceForces dimensional_forces(const DiscreteProblem &problem,
                              const SpaceScene &scene,
                              const Solution &solution);

/** Forces of each row, as in Solution::forces, of those of the user. */
std::vector<double> nondimensional_forces(const DiscreteProblem &problem,
                                          const SpaceScene &scene,
                                          const FaceForces &forces);
} // namespace Voussoir

#endif
