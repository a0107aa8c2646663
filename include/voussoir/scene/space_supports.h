// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_space_supports_h
#define voussoir_scene_space_supports_h

#include <voussoir/packing/polyhedra/packing.h>
#include <voussoir/scene/support_displacements.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** The section `Supports` in space: what the ground holds, and how it moves. */
class SpaceSupports
{
public:
  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * Fix the chosen blocks, and let the chosen boundary faces rest on the
   * ground.
   *
   * @throws InputError if a condition cannot be evaluated or holds on no face,
   *   if there is no group or cell of a name, or if no block is left that
   *   moves.
   */
  Packing<3> support(Packing<3> packing) const;

  /** SupportDisplacements::motion(). */
  std::vector<SpaceSupportMotion> motion(const Packing<3> &packing) const
  {
    return displacements.motion(packing);
  }

private:
  std::string where = "0", blocks;
  SupportDisplacements<3> displacements;
};
} // namespace Voussoir

#endif
