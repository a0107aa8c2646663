// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/cell_means.h>
#include <voussoir/stress/side_forces.h>

namespace Voussoir
{
using dealii::Tensor;

std::vector<Tensor<2, 2>> cell_mean_stresses(const Scene &scene,
                                             const InterfaceForces &forces)
{
  const Packing<2> &packing = scene.packing;
  std::vector<Tensor<2, 2>> mean(packing.n_cells());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    {
      const SideForce of_side = side_force(scene, forces, c, i);
      const dealii::Point<2> &a = packing.vertex(c, i);
      const Tensor<1, 2> half = 0.5 * (packing.vertex(c, i + 1) - a);
      mean[c] += outer_product(of_side.force, a + half - packing.centre(c)) +
                 outer_product(of_side.shift, half);
    }
    mean[c] += scene.body.moment(c);
  }
  for (unsigned int k = 0; k < scene.links.size(); ++k)
  {
    const Link &link = scene.links[k];
    const Tensor<1, 2> force = forces.in_links[k] * link.direction;
    mean[link.cell_minus] +=
        outer_product(force, link.on_minus - packing.centre(link.cell_minus));
    if (link.cell_plus != packing.ground())
      mean[link.cell_plus] -=
          outer_product(force, link.on_plus - packing.centre(link.cell_plus));
  }
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    mean[c] /= packing.area(c);
  return mean;
}
} // namespace Voussoir
