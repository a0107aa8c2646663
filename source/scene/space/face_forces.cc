// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/space/face_forces.h>

namespace Voussoir
{
std::vector<dealii::Tensor<1, 3>>
FaceForces::at_vertices(const unsigned int e,
                        const unsigned int n_vertices) const
{
  std::vector<dealii::Tensor<1, 3>> forces(n_vertices);
  const unsigned int n = first[e + 1] - first[e];
  if (n % n_vertices != 0)
  {
    for (unsigned int k = first[e]; k < first[e + 1]; ++k)
      for (dealii::Tensor<1, 3> &force : forces)
        force += list[k].force / n_vertices;
    return forces;
  }
  // Of each vertex one pressure, and behind them the cells of its kite.
  const bool has_cells = n > n_vertices;
  const unsigned int n_cells = has_cells ? n / n_vertices - 1 : 0;
  for (unsigned int v = 0; v < n_vertices; ++v)
  {
    forces[v] += list[first[e] + v].force;
    for (unsigned int k = 0; k < n_cells; ++k)
      forces[v] += list[first[e] + n_vertices + v * n_cells + k].force;
  }
  return forces;
}

FaceResultant FaceForces::resultant(const Packing<3> &packing,
                                    const unsigned int e) const
{
  FaceResultant sum;
  for (unsigned int k = first[e]; k < first[e + 1]; ++k)
  {
    sum.force += list[k].force;
    sum.moment += cross_product_3d(
        list[k].place - packing.interfaces()[e].centroid, list[k].force);
  }
  return sum;
}
} // namespace Voussoir
