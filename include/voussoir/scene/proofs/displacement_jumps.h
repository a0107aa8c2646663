// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_displacement_jumps_h
#define voussoir_scene_proofs_displacement_jumps_h

#include <voussoir/scene/scene.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** The jumps of a motion across the interfaces, in its unit. */
struct InterfaceJumps
{
  /** [u]_e . n_e at the start and the end of each, negative where it closes. */
  std::vector<std::array<double, 2>> openings;
  /** [u]_e . t_e of each, which is the same all along it. */
  std::vector<double> sliding;
  /** The largest displacement of a cell or of an end of an interface with it.
   */
  double largest_displacement = 0.;
};

/** The jumps of @p motion. */
InterfaceJumps jumps_of(const Packing<2> &packing, const Motion &motion);

/**
 * How much further apart @p motion draws the ends of link @p k of a scene along
 * its direction, in the unit of the motion; the ground under it is at rest.
 */
double elongation(const Scene &scene, unsigned int k, const Motion &motion);

/**
 * The work of the loads of @p scene, and of the forces of rest of its links,
 * along @p motion; S L times its unit.
 */
double work_of_loads(const Scene &scene, const Motion &motion);
} // namespace Voussoir

#endif
