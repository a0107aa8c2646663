// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/report/load_arrows.h>

namespace Voussoir
{
namespace
{
/** A force, over the sizes of the loads on a cell, that is rounding. */
constexpr double rounding_of_loads = 1e-9;
} // namespace

std::vector<LoadArrow> load_arrows(const Scene &scene)
{
  using Kind = LoadArrow::Kind;
  const Packing<2> &packing = scene.packing;
  std::vector<LoadArrow> arrows;
  std::vector<dealii::Tensor<1, 2>> rest = scene.load;
  const auto &edges = packing.boundary_edges();
  for (unsigned int b = 0; b < edges.size(); ++b)
  {
    const dealii::Tensor<1, 2> force = edges[b].length * scene.traction[b];
    if (force.norm() == 0.)
      continue;
    rest[edges[b].cell] -= force;
    arrows.push_back({Kind::traction, edges[b].midpoint(), force,
                      force * edges[b].normal < 0.});
  }
  for (const CellForce &given : scene.on_cells)
    for (const unsigned int c : given.cells)
    {
      rest[c] -= given.force;
      const dealii::Tensor<1, 2> &f = given.force;
      if (f.norm() == 0.)
        continue;
      arrows.push_back({Kind::cell_force, given.place_in(packing, c), f, true});
    }
  if (!scene.has_body_force)
    return arrows;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (rest[c].norm() > rounding_of_loads * scene.load_size[c])
      arrows.push_back({Kind::body_force, packing.centre(c), rest[c], false});
  return arrows;
}
} // namespace Voussoir
