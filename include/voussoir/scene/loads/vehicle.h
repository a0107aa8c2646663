// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_vehicle_h
#define voussoir_scene_loads_vehicle_h

#include <voussoir/packing/packing.h>
#include <voussoir/scene/loads/cell_forces.h>
#include <voussoir/scene/loads/spreading.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The section `Vehicle` of loads: forces downwards, one an axle, where the top
 * of the blocks is at its x.
 */
class VehicleParameters
{
public:
  /** Declare the section and bind it. */
  void add_parameters(dealii::ParameterHandler &prm);

  /**
   * The forces of the axles on the blocks below them; none without axles. Where
   * two blocks are equally high each takes the same share, and what stands
   * beside the blocks loads none. On soil that spreads loads an axle stands on
   * the surface of that.
   *
   * @param soil the bodies of it; the first that brings a force to blocks does.
   * @param section the path of the one around, for messages.
   * @param warnings to add to if an axle stands beside the blocks.
   * @throws InputError if an axle is not "distance: force" of finite numbers,
   *   the force positive, or the width is not positive.
   */
  std::vector<CellForce> forces(const Packing<2> &packing,
                                const std::vector<Spreading> &soil,
                                const std::string &section,
                                std::vector<std::string> &warnings) const;

private:
  std::string axles;
  double position = 0.;
  bool is_reversed = false;
  double width = 1.;
};

/**
 * The boundary edges, not vertical and with an outward normal that points up,
 * that are highest at @p x; several if they meet there, none if no block is
 * there.
 */
std::vector<unsigned int> highest_edges(const Packing<2> &packing, double x);
} // namespace Voussoir

#endif
