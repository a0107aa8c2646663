// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/space_results.h>

#include <deal.II/base/parallel.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cstddef>

namespace Voussoir
{
namespace
{
/** Values nearer than this, over the largest, lose digits in closed form. */
constexpr double near = 1e-3;
/** The cells that a thread takes at a time. */
constexpr unsigned int grain_size = 256;
} // namespace

PrincipalStresses principal_stresses(const dealii::Tensor<2, 3> &sigma)
{
  const dealii::SymmetricTensor<2, 3> symmetric = dealii::symmetrize(sigma);
  const auto values = dealii::eigenvalues(symmetric);
  const double least_distance =
      std::min(values[0] - values[1], values[1] - values[2]);
  if (least_distance > near * std::max(values[0], -values[2]))
    return {values[2], values[0]};
  const auto pairs = dealii::eigenvectors(
      symmetric, dealii::SymmetricTensorEigenvectorMethod::jacobi);
  return {pairs[2].first, pairs[0].first};
}

void SpaceResults::find_principal_stresses()
{
  const CellFaces &cells = scene.packing().polyhedra();
  const auto extremes_of = [&](const unsigned int c) {
    PrincipalStresses found = principal_stresses(mean_stresses[c]);
    const auto add = [&found](const dealii::Tensor<2, 3> &sigma) {
      const PrincipalStresses there = principal_stresses(sigma);
      found.least = std::min(found.least, there.least);
      found.greatest = std::max(found.greatest, there.greatest);
    };
    // Of a linear stress they are at vertices: the one is a concave and the
    // other a convex function of it.
    if (!stresses.empty())
      for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1];
           ++f)
        for (const unsigned int v : cells.corners(f))
          add(stresses[c].at(cells.vertices[v]));
    if (tetrahedra)
      for (std::size_t t = tetrahedra->first[c]; t < tetrahedra->first[c + 1];
           ++t)
        add(tetrahedra->list[t].stress);
    return found;
  };
  principal.resize(mean_stresses.size());
  dealii::parallel::apply_to_subranges(
      0u, static_cast<unsigned int>(principal.size()),
      [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int c = begin; c < end; ++c)
          principal[c] = extremes_of(c);
      },
      grain_size);
}
} // namespace Voussoir
