// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_body_force_formulas_h
#define voussoir_scene_loads_body_force_formulas_h

#include <voussoir/packing/packing.h>
#include <voussoir/scene/loads/body_force.h>
#include <voussoir/scene/loads/resultant.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** An entry of a .prm file. */
struct TextOfParameter
{
  /** Its path. */
  std::string parameter;
  /** Its value. */
  std::string value;
};

/**
 * The body force that a user gives by formulas in x and y.
 *
 * @param everywhere "b_x; b_y" of the cells that have no other, or lists with a
 *   number for each cell; S/L.
 * @param of_groups "name: b_x; b_y | ..." of those of groups, or of cells by
 *   number.
 * @param warnings on integrals that are not exact are added.
 * @param requested gets the force and its moment.
 * @throws InputError naming the place if a value is not a finite number or
 *   varies too fast for its integral; if a formula cannot be parsed, a name is
 *   that of no cell, or a cell is given two.
 */
BodyForce body_force_of_formulas(const Packing<2> &packing,
                                 const TextOfParameter &everywhere,
                                 const TextOfParameter &of_groups,
                                 std::vector<std::string> &warnings,
                                 Resultant &requested);
} // namespace Voussoir

#endif
