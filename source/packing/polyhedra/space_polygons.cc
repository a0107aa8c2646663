// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/space_polygons.h>

namespace Voussoir
{
namespace
{
using dealii::Tensor;

/** The moments of a polygon of @p n corners, which are at corner(i). */
template <typename Corner>
PolygonMoments moments_of_corners(const std::size_t n, const Corner &corner)
{
  PolygonMoments moments;
  if (n == 0)
    return moments;
  const dealii::Point<3> &origin = corner(0);
  for (std::size_t i = 1; i + 1 < n; ++i)
    moments.vector_area +=
        0.5 * cross_product_3d(corner(i) - origin, corner(i + 1) - origin);
  moments.centroid = origin;
  const double area = moments.area();
  if (!(area > 0.))
    return moments;
  const Tensor<1, 3> normal = moments.normal();
  Tensor<1, 3> first;
  for (std::size_t i = 1; i + 1 < n; ++i)
  {
    const Tensor<1, 3> a = corner(i) - origin, b = corner(i + 1) - origin;
    first += cross_product_3d(a, b) * normal / 6. * (a + b);
  }
  moments.centroid += first / area;
  return moments;
}
} // namespace

PolygonMoments
moments_of(const dealii::ArrayView<const dealii::Point<3>> polygon)
{
  return moments_of_corners(
      polygon.size(), [&](const std::size_t i) -> const auto & {
        return polygon[i];
      });
}

PolygonMoments moments_of_face(const CellFaces &cells, const unsigned int face)
{
  const dealii::ArrayView<const unsigned int> corners = cells.corners(face);
  return moments_of_corners(
      corners.size(), [&](const std::size_t i) -> const auto & {
        return cells.vertices[corners[i]];
      });
}
} // namespace Voussoir
