// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/space_polygons.h>

namespace Voussoir
{
using dealii::Tensor;

PolygonMoments
moments_of(const dealii::ArrayView<const dealii::Point<3>> polygon)
{
  PolygonMoments moments;
  if (polygon.size() == 0)
    return moments;
  const dealii::Point<3> &origin = polygon[0];
  for (unsigned int i = 1; i + 1 < polygon.size(); ++i)
    moments.vector_area +=
        0.5 * cross_product_3d(polygon[i] - origin, polygon[i + 1] - origin);
  moments.centroid = origin;
  const double area = moments.area();
  if (!(area > 0.))
    return moments;
  const Tensor<1, 3> normal = moments.normal();
  Tensor<1, 3> first;
  for (unsigned int i = 1; i + 1 < polygon.size(); ++i)
  {
    const Tensor<1, 3> a = polygon[i] - origin, b = polygon[i + 1] - origin;
    first += cross_product_3d(a, b) * normal / 6. * (a + b);
  }
  moments.centroid += first / area;
  return moments;
}
} // namespace Voussoir
