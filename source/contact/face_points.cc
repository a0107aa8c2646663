// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/contact/face_points.h>

#include <array>
#include <cmath>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** A quadrilateral that has a kite, its corners in order. */
using Quadrilateral = std::array<Point<3>, 4>;

/** The point of a bilinear map of the unit square. */
Point<3> point_in(const Quadrilateral &q, const double s, const double t)
{
  return Point<3>((1. - s) * (1. - t) * q[0] + s * (1. - t) * q[1] +
                  s * t * q[2] + (1. - s) * t * q[3]);
}

/** Its centroid, with the area for a share. */
FacePoint centroid_of(const Quadrilateral &q)
{
  const PolygonMoments moments =
      moments_of(dealii::ArrayView<const Point<3>>(q.data(), q.size()));
  return {moments.centroid, moments.area()};
}

void add_parts(const Quadrilateral &kite,
               const unsigned int n_cuts,
               std::vector<FacePoint> &points)
{
  const double h = 1. / n_cuts;
  for (unsigned int i = 0; i < n_cuts; ++i)
    for (unsigned int j = 0; j < n_cuts; ++j)
      points.push_back(centroid_of(
          {{point_in(kite, i * h, j * h), point_in(kite, (i + 1) * h, j * h),
            point_in(kite, (i + 1) * h, (j + 1) * h),
            point_in(kite, i * h, (j + 1) * h)}}));
}

void divide_by_sum(std::vector<FacePoint> &points)
{
  double sum = 0.;
  for (const FacePoint &point : points)
    sum += point.share;
  for (FacePoint &point : points)
    point.share /= sum;
}
} // namespace

FacePoints face_points(const dealii::ArrayView<const Point<3>> polygon,
                       const bool blocks_turn,
                       const unsigned int n_cuts)
{
  const Point<3> centre = moments_of(polygon).centroid;
  if (!blocks_turn)
    return {{{centre, 1.}}, {{centre, 1.}}};
  const unsigned int n = polygon.size();
  FacePoints points;
  const auto middle = [&](const unsigned int k) {
    return Point<3>(0.5 * (polygon[k] + polygon[(k + 1) % n]));
  };
  for (unsigned int k = 0; k < n; ++k)
  {
    const Quadrilateral kite = {
        {centre, middle((k + n - 1) % n), polygon[k], middle(k)}};
    points.pressure.push_back({polygon[k], centroid_of(kite).share});
    add_parts(kite, n_cuts, points.friction);
  }
  divide_by_sum(points.pressure);
  divide_by_sum(points.friction);
  return points;
}

Tensor<1, 3> tangent_of(const Tensor<1, 3> &normal)
{
  unsigned int least = 0;
  for (unsigned int i = 1; i < 3; ++i)
    if (std::abs(normal[i]) < std::abs(normal[least]))
      least = i;
  Tensor<1, 3> axis;
  axis[least] = 1.;
  const Tensor<1, 3> tangent = cross_product_3d(normal, axis);
  return tangent / tangent.norm();
}
} // namespace Voussoir
