// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_load_parts_h
#define voussoir_scene_loads_load_parts_h

#include <voussoir/scene/scene.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** A part of the load that a user knows by name. */
struct LoadPart
{
  /** Its name, such as "the traction on the side from (0, 1) to (1, 1)". */
  std::string name;
  /** Along the displacement given; a force per unit thickness times that. */
  double work;
};

/**
 * The work of the parts of the load along the displacements u_c, one for each
 * cell.
 *
 * They are those of the traction on each straight side of the packing that is
 * loaded, of the body force and of the forces on cells of each name, the most
 * work first. The works add up to sum_c F_c . u_c.
 */
std::vector<LoadPart> load_parts(const Scene &scene, const Motion &motion);

/** The share of the first part in all work that is positive; 0 if none is. */
double share_of_first(const std::vector<LoadPart> &parts);
} // namespace Voussoir

#endif
