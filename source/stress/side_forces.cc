// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/stress/side_forces.h>

namespace Voussoir
{
using dealii::Tensor;

SideForce side_force(const Scene &scene,
                     const InterfaceForces &forces,
                     const unsigned int cell,
                     const unsigned int i)
{
  const Packing<2> &packing = scene.packing;
  const Packing<2>::Side &side = packing.sides(cell)[i];
  if (side.on_boundary)
  {
    const double length = packing.boundary_edges()[side.index].length;
    return {length * scene.traction[side.index],
            2. / length * scene.traction_moment[side.index]};
  }

  const Packing<2>::Interface &interface = packing.interfaces()[side.index];
  const double sign = interface.cell_minus == cell ? 1. : -1.;
  SideForce of_side;
  of_side.force = sign * forces.on_cell_minus(interface, side.index);
  if (!scene.turns())
    return of_side;
  const dealii::Point<2> &a = packing.vertex(cell, i),
                         &b = packing.vertex(cell, i + 1);
  const Tensor<1, 2> along = b - a;
  // Zero to the last digit where the side is the interface, either way round.
  const Tensor<1, 2> beside =
      0.5 * ((interface.start - a) + (interface.end - b));
  const double couple = sign * forces.couple(interface, side.index) +
                        cross(beside, of_side.force);
  of_side.shift[0] = -2. * couple * along[1] / along.norm_square();
  of_side.shift[1] = 2. * couple * along[0] / along.norm_square();
  return of_side;
}

CellForces cell_forces(const Scene &scene,
                       const InterfaceForces &forces,
                       const CellRange &cells)
{
  const Packing<2> &packing = scene.packing;
  const std::size_t n_sides =
      packing.first_side(cells.end) - packing.first_side(cells.begin);
  CellForces result;
  result.on_side.reserve(n_sides);
  if (scene.turns())
    result.shift_on_side.reserve(n_sides);
  if (!scene.body.empty())
    result.body.reserve(n_sides);
  for (unsigned int c = cells.begin; c < cells.end; ++c)
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    {
      const SideForce of_side = side_force(scene, forces, c, i);
      result.on_side.push_back(of_side.force);
      if (scene.turns())
        result.shift_on_side.push_back(of_side.shift);
      if (!scene.body.empty())
        result.body.push_back(scene.body.force(packing, c, i));
    }
  return result;
}
} // namespace Voussoir
