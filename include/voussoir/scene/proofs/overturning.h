// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_overturning_h
#define voussoir_scene_proofs_overturning_h

#include <voussoir/scene/scene.h>

#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * Connected blocks that forces found without rotations would turn as a whole,
 * wherever on the interfaces around them the resultants lie.
 */
struct Overturning
{
  /** Their numbers, ascending. */
  std::vector<unsigned int> cells;
  /** Their interfaces with other blocks and the ground. */
  std::vector<unsigned int> interfaces;
  /**
   * The moment on them of the loads and of the forces at the midpoints of these
   * interfaces, positive counterclockwise; S L^2. It is the same about any
   * point.
   */
  double moment;
  /**
   * The largest moment that these interfaces can balance, their resultants
   * being at the ends: the sum of |f_e^n| |e| / 2; S L^2.
   */
  double resistance;
};

/**
 * Decide whether the forces of a run without rotations are also those of one
 * with rotations, in which each resultant has a place on its interface.
 *
 * Blocks are balanced when the residual torque T_c of each is taken up by
 * couples of its interfaces, at most |f_e^n| |e| / 2 each: a flow from cell to
 * cell of given sources and capacities. The largest flow either takes up all,
 * or is cut off around blocks whose moment is too large for the interfaces
 * around them.
 *
 * @param forces with torques that are not rounding; see
 *   Certificate::max_torque.
 * @return nothing if the torques can be taken up: then the load is carried with
 *   rotations, too. Otherwise the blocks most of whose moment
 *   is left; other forces may yet hold them.
 */
std::optional<Overturning> find_overturning(const Scene &scene,
                                            const InterfaceForces &forces);
} // namespace Voussoir

#endif
