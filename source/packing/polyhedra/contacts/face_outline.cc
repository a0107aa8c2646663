// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/packing/polyhedra/contacts/face_outline.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

/**
 * How far beyond the ends of a side, over its length, it still cuts: rounding
 * leaves no hole at a corner. A cut too many does no harm.
 */
constexpr double beyond_ends = 1e-9;

/** Restrict a part to where a linear function is not negative. */
void restrict_to(SegmentPart &part, const double at_begin, const double at_end)
{
  if (at_begin < 0. && at_end < 0.)
    part = {{1., 0.}};
  else if (at_begin < 0.)
    part[0] = std::max(part[0], at_begin / (at_begin - at_end));
  else if (at_end < 0.)
    part[1] = std::min(part[1], at_begin / (at_begin - at_end));
}
} // namespace

FaceOutline::FaceOutline(const FaceGeometry &geometry, const unsigned int face)
    : tolerance(geometry.tolerance),
      frame(geometry.cells.vertex(face, 0), geometry.planes[face].normal),
      height_of_plane(frame.height(geometry.planes[face].centre))
{
  for (const unsigned int v : geometry.cells.corners(face))
    corners.push_back(frame.project(geometry.cells.vertices[v]));
}

double FaceOutline::depth(const Point<2> &at) const
{
  bool is_inside = false;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point<2> &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const Tensor<1, 2> side = q - p, arm = at - p;
    if ((p[1] > at[1]) != (q[1] > at[1]) &&
        (cross(side, arm) > 0.) == (side[1] > 0.))
      is_inside = !is_inside;
    const double square = side.norm_square();
    const double t = square > 0. ? std::clamp(arm * side / square, 0., 1.) : 0.;
    least = std::min(least, (arm - t * side).norm());
  }
  return is_inside ? least : -least;
}

std::vector<SegmentPart> FaceOutline::parts_inside(const Point<3> &begin,
                                                   const Point<3> &end) const
{
  const Point<2> a = frame.project(begin), b = frame.project(end);
  const Tensor<1, 2> along = b - a;
  const double length = along.norm();
  std::vector<double> cuts = {0., 1.};
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point<2> &p = corners[i];
    const Tensor<1, 2> side = corners[(i + 1) % corners.size()] - p;
    const double sine = cross(along, side);
    if (sine == 0.)
      continue;
    const double at_segment = cross(p - a, side) / sine,
                 at_side = cross(p - a, along) / sine;
    if (at_segment > 0. && at_segment < 1. && at_side >= -beyond_ends &&
        at_side <= 1. + beyond_ends)
      cuts.push_back(at_segment);
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<SegmentPart> parts;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
  {
    if (!((cuts[k + 1] - cuts[k]) * length > tolerance) ||
        !(depth(a + 0.5 * (cuts[k] + cuts[k + 1]) * along) > tolerance))
      continue;
    if (!parts.empty() && parts.back()[1] == cuts[k])
      parts.back()[1] = cuts[k + 1];
    else
      parts.push_back({{cuts[k], cuts[k + 1]}});
  }
  return parts;
}

SegmentPart part_near(const dealii::ArrayView<const Point<3>> &polygon,
                      const Tensor<1, 3> &normal,
                      const std::array<Point<3>, 2> &segment,
                      const double distance)
{
  SegmentPart part = {{0., 1.}};
  for (unsigned int i = 0; i < polygon.size(); ++i)
  {
    const Point<3> &p = polygon[i];
    const Tensor<1, 3> side = polygon[(i + 1) % polygon.size()] - p;
    const double length = side.norm();
    if (!(length > 0.))
      continue;
    const Tensor<1, 3> inwards = cross_product_3d(normal, side / length);
    restrict_to(part, inwards * (segment[0] - p) + distance,
                inwards * (segment[1] - p) + distance);
  }
  for (const double sign : {-1., 1.})
    restrict_to(part, distance + sign * (normal * (segment[0] - polygon[0])),
                distance + sign * (normal * (segment[1] - polygon[0])));
  return part;
}
} // namespace Voussoir
