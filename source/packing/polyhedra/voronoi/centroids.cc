// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/cell_moments.h>
#include <voussoir/packing/polyhedra/voronoi/centroids.h>

#include <deal.II/base/tensor.h>

#include <cmath>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

/**
 * The power of the size that weights the points of a cell: centroidal cells in
 * space have a size proportional to the weight's power -1/5.
 */
constexpr int power_of_size = -5;

Point<3> weighted_centroid(const CellFaces &cells,
                           const unsigned int cell,
                           const CellSize<3> &size)
{
  // A point of the rule has one barycentric coordinate near and three others.
  const double others = (5. - std::sqrt(5.)) / 20., near = 1. - 3. * others;
  const Point<3> &centre = cells.centres[cell];
  const double reference = size(centre);
  double mass = 0.;
  Tensor<1, 3> moment;
  for (unsigned int f = cells.first_face[cell]; f < cells.first_face[cell + 1];
       ++f)
  {
    const Tensor<1, 3> a = cells.vertex(f, 0) - centre;
    for (unsigned int i = 1; i + 1 < cells.n_corners(f); ++i)
    {
      const Tensor<1, 3> b = cells.vertex(f, i) - centre;
      const Tensor<1, 3> c = cells.vertex(f, i + 1) - centre;
      const double volume = a * cross_product_3d(b, c) / 6.;
      const Tensor<1, 3> base = others * (a + b + c);
      for (const Tensor<1, 3> &corner : {Tensor<1, 3>(), a, b, c})
      {
        const Tensor<1, 3> x = base + (near - others) * corner;
        const double weight =
            std::pow(size(centre + x) / reference, power_of_size);
        mass += weight * volume / 4.;
        moment += weight * volume / 4. * x;
      }
    }
  }
  return centre + moment / mass;
}
} // namespace

std::vector<Point<3>> weighted_centroids(const CellFaces &cells,
                                         const CellSize<3> &size)
{
  std::vector<Point<3>> centroids;
  centroids.reserve(cells.n_cells());
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    centroids.push_back(size.is_constant() ? moments_of(cells, c).centroid
                                           : weighted_centroid(cells, c, size));
  return centroids;
}
} // namespace Voussoir
