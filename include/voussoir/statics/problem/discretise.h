// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_problem_discretise_h
#define voussoir_statics_problem_discretise_h

#include <voussoir/scene/scene.h>
#include <voussoir/statics/problem/dimensional.h>
#include <voussoir/statics/problem/discrete_problem.h>

#include <vector>

namespace Voussoir
{
// From a scene in the user's units to the nondimensional problem, and by
// dimensional.h back: of statics only these know what a scene is, and how many
// dimensions it has.

/**
 * The problem of a scene: joints in the order of Packing::interfaces(), and
 * bodies in that of the cells and at last the ground, if there are supports.
 */
DiscreteProblem discretise(const Scene &scene);

/**
 * The problem of some cells only, of which @p moves is true; all others are
 * held and belong to the ground, without the joints between them. Its
 * mechanisms, with the others at rest, are mechanisms of the scene.
 */
DiscreteProblem discretise(const Scene &scene, const std::vector<bool> &moves);

/**
 * The loads of another scene on the packing of @p problem, in its units:
 * n_dofs() numbers, without those on the ground.
 */
std::vector<double> discretise_loads(const DiscreteProblem &problem,
                                     const Scene &scene);
} // namespace Voussoir

#endif
