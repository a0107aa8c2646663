// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/cell_forces.h>

namespace Voussoir
{
CellForces cell_forces(const Scene &scene,
                       const InterfaceForces &forces,
                       const CellRange &cells)
{
  const Packing &packing = scene.packing;
  const std::size_t n_sides =
      packing.first_side(cells.end) - packing.first_side(cells.begin);
  CellForces result;
  result.on_side.reserve(n_sides);
  if (scene.turns())
    result.shift_on_side.reserve(n_sides);
  if (!scene.body.empty())
    result.body.reserve(n_sides);
  for (unsigned int c = cells.begin; c < cells.end; ++c)
  {
    const auto sides = packing.sides(c);
    for (unsigned int i = 0; i < sides.size(); ++i)
    {
      const unsigned int k = sides[i].index;
      if (sides[i].on_boundary)
      {
        const double length = packing.boundary_edges()[k].length;
        result.on_side.push_back(length * scene.traction[k]);
        if (scene.turns())
          result.shift_on_side.push_back(2. / length *
                                         scene.traction_moment[k]);
      }
      else
      {
        const Packing::Interface &interface = packing.interfaces()[k];
        const dealii::Tensor<1, 2> f = forces.on_cell_minus(interface, k);
        result.on_side.push_back(interface.cell_minus == c ? f : -f);
        // The same for both cells: force and direction are opposite.
        if (scene.turns())
          result.shift_on_side.push_back(-2. / interface.length *
                                         forces.couple(interface, k) *
                                         interface.normal);
      }
      if (!scene.body.empty())
        result.body.push_back(scene.body.force(packing, c, i));
    }
  }
  return result;
}
} // namespace Voussoir
