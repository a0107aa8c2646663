// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/cell_means.h>

namespace Voussoir
{
using dealii::Tensor;

std::vector<Tensor<2, 2>> cell_mean_stresses(const Scene &scene,
                                             const InterfaceForces &forces)
{
  const Packing &packing = scene.packing;
  std::vector<Tensor<2, 2>> mean(packing.n_cells());
  const auto add = [&](const unsigned int cell, const dealii::Point<2> &x,
                       const Tensor<1, 2> &force) {
    mean[cell] +=
        outer_product(force, x - packing.centre(cell)) / packing.area(cell);
  };

  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const Packing::Interface &i = packing.interfaces()[e];
    const auto add_both = [&](const dealii::Point<2> &x,
                              const Tensor<1, 2> &f) {
      add(i.cell_minus, x, f);
      if (i.cell_plus != packing.ground())
        add(i.cell_plus, x, -f);
    };
    if (forces.at_ends.empty())
      add_both(i.midpoint(), forces.on_cell_minus(i, e));
    else
    {
      add_both(i.midpoint(), forces.tangential[e] * i.tangent());
      add_both(i.start, forces.at_ends[e][0] * i.normal);
      add_both(i.end, forces.at_ends[e][1] * i.normal);
    }
  }
  for (unsigned int b = 0; b < packing.boundary_edges().size(); ++b)
  {
    const Packing::BoundaryEdge &edge = packing.boundary_edges()[b];
    add(edge.cell, edge.midpoint(), edge.length * scene.traction[b]);
    mean[edge.cell] += outer_product(scene.traction_moment[b],
                                     (edge.end - edge.start) / edge.length) /
                       packing.area(edge.cell);
  }
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    mean[c] += scene.body.moment(c) / packing.area(c);
  return mean;
}
} // namespace Voussoir
