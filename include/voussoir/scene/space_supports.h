// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_space_supports_h
#define voussoir_scene_space_supports_h

#include <voussoir/packing/polyhedra/packing.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace Voussoir
{
/** The section `Supports` in space: what of a packing the ground holds. */
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

private:
  std::string where = "0", blocks;
};
} // namespace Voussoir

#endif
