// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_settlement_h
#define voussoir_analyses_ranges_settlement_h

#include <voussoir/scene/scene.h>
#include <voussoir/scene/space/face_forces.h>
#include <voussoir/scene/space/space_motion.h>
#include <voussoir/scene/space/space_scene.h>

#include <vector>

namespace Voussoir
{
/**
 * What a packing does when its supports move, in the plane or in space: a
 * motion of least energy,
 *
 *     minimise  sum_e (the resistance of joint e to its jump) - sum_c F_c . u_c
 *
 * among all that close no joint, and forces of its dual problem: of all states,
 * one in which the ground does the most work on the displacements of the
 * supports. They belong together: forces press no joint that opens, and
 * friction is at its limit, in its direction, wherever blocks slide. Each
 * proves the other; see bound_of().
 */
template <typename SceneOf>
struct SettlementOf
{
  /** A state that carries the loads. */
  typename SceneOf::Forces forces;
  /**
   * The motion, with that of the supports in it; L. If there are others of the
   * same energy, in the plane one with the least sum of the sizes of all
   * displacements, and of all angles times the root of the mean area of a cell;
   * in space one between them.
   */
  typename SceneOf::MotionOfBlocks motion;
  /**
   * The work of the ground on the displacements of the supports; S L^2, in
   * space S L^3.
   */
  double work = 0.;
  /** What the motion proves that it is at most, less the work. */
  double width = 0.;
  /** ForceBound::closing_violation. */
  double closing_violation = 0.;
  /** The largest displacement of a support at its ends or vertices; L. */
  double largest_displacement = 0.;
  /** The number of steps of the simplex method. */
  unsigned int n_iterations = 0;
};

/** That in the plane. */
using Settlement = SettlementOf<Scene>;

/** @{ */
/**
 * Find it.
 *
 * @param scene whose loads are carried, with a law whose blocks dilate.
 * @param of_supports of a motion; not all zero.
 * @throws InputError if the law is not associated, supports turn and blocks do
 * not, or forces of any size resist the displacements.
 * @throws SolverError if a programme has no answer, or its proofs are none.
 */
Settlement find_settlement(const Scene &scene,
                           const std::vector<SupportMotion> &of_supports);
SettlementOf<SpaceScene>
find_settlement(const SpaceScene &scene,
                const std::vector<SpaceSupportMotion> &of_supports);
/** @} */
} // namespace Voussoir

#endif
