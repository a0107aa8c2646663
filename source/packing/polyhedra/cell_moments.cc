// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/cell_moments.h>

#include <algorithm>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

CellMoments moments_of(const CellFaces &cells, const unsigned int cell)
{
  CellMoments moments;
  const unsigned int begin = cells.first_face[cell];
  const unsigned int end = cells.first_face[cell + 1];
  if (begin == end)
    return moments;
  const Point<3> &origin = cells.vertex(begin, 0);
  Tensor<1, 3> first;
  dealii::SymmetricTensor<2, 3> second;
  for (unsigned int f = begin; f < end; ++f)
  {
    const Tensor<1, 3> a = cells.vertex(f, 0) - origin;
    for (unsigned int i = 1; i + 1 < cells.n_corners(f); ++i)
    {
      const Tensor<1, 3> b = cells.vertex(f, i) - origin;
      const Tensor<1, 3> c = cells.vertex(f, i + 1) - origin;
      const double volume = a * cross_product_3d(b, c) / 6.;
      const Tensor<1, 3> sum = a + b + c;
      moments.volume += volume;
      first += volume / 4. * sum;
      // Of a tetrahedron with a corner in the origin.
      for (const Tensor<1, 3> &x : {a, b, c, sum})
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = i; j < 3; ++j)
            second[i][j] += volume / 20. * x[i] * x[j];
    }
  }
  moments.centroid = origin;
  if (moments.volume == 0.)
    return moments;
  const Tensor<1, 3> arm = first / moments.volume;
  moments.centroid += arm;
  moments.second =
      second - moments.volume * symmetrize(outer_product(arm, arm));
  return moments;
}

dealii::BoundingBox<3> box_of(const CellFaces &cells)
{
  if (cells.loops.empty())
    return dealii::BoundingBox<3>(std::make_pair(Point<3>(), Point<3>()));
  Point<3> low = cells.vertices[cells.loops[0]], high = low;
  for (const unsigned int v : cells.loops)
    for (unsigned int d = 0; d < 3; ++d)
    {
      low[d] = std::min(low[d], cells.vertices[v][d]);
      high[d] = std::max(high[d], cells.vertices[v][d]);
    }
  return dealii::BoundingBox<3>(std::make_pair(low, high));
}

std::vector<std::array<unsigned int, 2>> open_edges(const CellFaces &cells,
                                                    const unsigned int cell)
{
  using Edge = std::array<unsigned int, 2>;
  std::vector<Edge> edges;
  for (unsigned int f = cells.first_face[cell]; f < cells.first_face[cell + 1];
       ++f)
  {
    const auto corners = cells.corners(f);
    for (unsigned int i = 0; i < corners.size(); ++i)
      edges.push_back({{corners[i], corners[(i + 1) % corners.size()]}});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> open;
  for (std::size_t k = 0; k < edges.size(); ++k)
  {
    const bool is_repeated = k > 0 && edges[k] == edges[k - 1];
    const Edge back = {{edges[k][1], edges[k][0]}};
    if (is_repeated || !std::binary_search(edges.begin(), edges.end(), back))
      open.push_back(edges[k]);
  }
  return open;
}
} // namespace Voussoir
