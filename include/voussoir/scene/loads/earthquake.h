// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_earthquake_h
#define voussoir_scene_loads_earthquake_h

#include <voussoir/packing/packing.h>
#include <voussoir/scene/loads/loads.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace Voussoir
{
/**
 * The section `Earthquake` of the live loads: all that acts downwards among the
 * dead loads, turned into a direction. In all as large as those, so that its
 * factor is the acceleration in shares of gravity, or the base shear over the
 * weight.
 */
class Earthquake
{
public:
  /** Declare the section in `Live loads`, and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /** True if there is none. */
  bool empty() const { return pattern == Pattern::none; }
  /**
   * The loads on @p packing.
   *
   * @param dead the loads whose parts along -y are the weights: a body force,
   * in the place of each of its parts, forces on cells, and tractions.
   * @throws InputError if the direction is none, the weights add up to nothing,
   *   or none of them is above the base.
   */
  Loads loads(const Packing<2> &packing, const Loads &dead) const;

private:
  enum class Pattern
  {
    none,
    mass,
    mass_and_height
  };

  Pattern pattern = Pattern::none;
  std::string direction = "1, 0";
};
} // namespace Voussoir

#endif
