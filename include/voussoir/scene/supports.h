// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_supports_h
#define voussoir_scene_supports_h

#include <voussoir/packing/packing.h>
#include <voussoir/scene/support_displacements.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Voussoir
{
/** The section `Supports`: which boundary edges rest on the ground. */
class SupportParameters
{
public:
  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * Let the chosen boundary edges of @p packing rest on the ground.
   *
   * @throws InputError if a condition is given that cannot be evaluated or
   * holds on no edge.
   */
  void support(Packing<2> &packing) const;

  /** SupportDisplacements::motion(). */
  std::vector<SupportMotion> motion(const Packing<2> &packing) const
  {
    return displacements.motion(packing);
  }

private:
  std::string where = "0";
  SupportDisplacements<2> displacements;
};

/**
 * True for each boundary edge on which @p condition holds, an expression in the
 * coordinates x, y of the midpoint and the outward unit normal nx, ny.
 *
 * @return one entry for each of Packing::boundary_edges().
 * @throws InputError naming @p parameter if it cannot be evaluated or holds on
 *   none.
 */
std::vector<bool> boundary_edges_where(const Packing<2> &packing,
                                       const std::string &condition,
                                       const std::string &parameter);
} // namespace Voussoir

#endif
