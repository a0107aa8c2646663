// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/voronoi/convex_polygon.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/**
 * The least distance of each vertex from the line through its neighbours,
 * relative to the size of the polygon: far above rounding, so that no side and
 * no corner is an accident of it, and far below any corner that is meant.
 */
constexpr double flattest_corner = 1e-9;

/** The size of a domain with whose squares and cubes one can compute. */
constexpr double smallest_extent = 1e-70, largest_extent = 1e70;

/**
 * The part of the distance to the nearest side within which a point is inside
 * without a look at the sides: one, less a rest far above rounding.
 */
constexpr double safe_part = 0.999;

/** The longer side of the smallest axis-parallel rectangle around @p points. */
double extent(const std::vector<Point<2>> &points)
{
  const dealii::BoundingBox<2> box(points);
  return std::max(box.side_length(0), box.side_length(1));
}

[[noreturn]] void
refuse(const std::vector<Point<2>> &vertices, unsigned int i, const char *fault)
{
  throw InputError(text("Vertex ", i, " of the polygon, at ",
                        text_of_point(vertices[i]), ", ", fault));
}

/** Check the corners of a polygon of @p orientation +1 or -1. */
void check_corners(const std::vector<Point<2>> &vertices,
                   const double orientation)
{
  const unsigned int n = vertices.size();
  const double least = flattest_corner * extent(vertices);
  for (unsigned int i = 0; i < n; ++i)
    if (vertices[i].distance(vertices[(i + n - 1) % n]) < least)
      refuse(vertices, i, "repeats the one before it; give each vertex once.");

  double turning = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    const Tensor<1, 2> before = vertices[i] - vertices[(i + n - 1) % n];
    const Tensor<1, 2> after = vertices[(i + 1) % n] - vertices[i];
    const double twice_area = orientation * cross(before, after);
    const double chord = (before + after).norm();
    if (twice_area < -least * chord)
      refuse(vertices, i,
             "is not a convex corner; the polygon must be convex, with its "
             "vertices in order around it.");
    if (!(twice_area > least * chord))
      refuse(vertices, i,
             "is on the line through its neighbours; leave it out.");
    turning += std::atan2(twice_area, before * after);
  }
  // A convex corner everywhere still allows a loop that winds twice.
  if (turning > 3. * dealii::numbers::PI)
    throw InputError("The sides of the polygon cross each other; give its "
                     "vertices in order around it.");
}
} // namespace

ConvexPolygon::ConvexPolygon(std::vector<Point<2>> given)
    : vertices(std::move(given)), shape_name("polygon")
{
  if (vertices.size() < 3)
    throw InputError(text("The polygon has ", vertices.size(),
                          " vertices; it needs at least three."));
  for (unsigned int i = 0; i < vertices.size(); ++i)
    if (!std::isfinite(vertices[i][0]) || !std::isfinite(vertices[i][1]))
      refuse(vertices, i, "is not finite; give two numbers \"x, y\".");
  const double area = [&] {
    // Vertices too large to compute with give NaN, which is refused below.
    const InvalidOperationsAllowed allowed;
    return signed_area(vertices);
  }();
  if (!std::isfinite(area) || area == 0.)
    throw InputError("The polygon has the area " + text_of_number(area) +
                     "; give its vertices in order around a positive area.");
  check_corners(vertices, area > 0. ? 1. : -1.);
  if (area < 0.)
    std::reverse(vertices.begin(), vertices.end());
  measure();
}

ConvexPolygon::ConvexPolygon(const Rectangle &rectangle)
    : vertices({rectangle.lower_left,
                {rectangle.upper_right[0], rectangle.lower_left[1]},
                rectangle.upper_right,
                {rectangle.lower_left[0], rectangle.upper_right[1]}}),
      shape_name("rectangle")
{
  measure();
}

void ConvexPolygon::measure()
{
  double largest = extent(vertices);
  const bool too_small = largest < smallest_extent;
  for (const Point<2> &v : vertices)
    largest = std::max({largest, std::abs(v[0]), std::abs(v[1])});
  if (too_small || largest > largest_extent)
    throw InputError("The " + description() +
                     " is too large or too small to compute with; choose a "
                     "unit of length in which it is between 1e-70 and 1e70.");
  normals.resize(n_sides());
  for (unsigned int i = 0; i < n_sides(); ++i)
  {
    const Tensor<1, 2> along = vertex(i + 1) - vertex(i);
    normals[i][0] = along[1] / along.norm();
    normals[i][1] = -along[0] / along.norm();
  }
  Tensor<1, 2> from_first;
  for (const Point<2> &v : vertices)
    from_first += (v - vertices[0]) / n_sides();
  middle = vertices[0] + from_first;

  inner_radius = std::numeric_limits<double>::infinity();
  for (unsigned int i = 0; i < n_sides(); ++i)
    inner_radius = std::min(inner_radius, -safe_part * beyond(middle, i));
}

bool ConvexPolygon::contains(const Point<2> &p, const double margin) const
{
  if (p.distance(middle) < inner_radius - margin)
    return true;
  for (unsigned int i = 0; i < n_sides(); ++i)
    if (!(beyond(p, i) < -margin))
      return false;
  return true;
}

std::string ConvexPolygon::description() const
{
  if (shape_name == "rectangle")
    return "rectangle from " + text_of_point(vertices[0]) + " to " +
           text_of_point(vertices[2]);
  return text("polygon with ", n_sides(), " vertices from ",
              text_of_point(vertices[0]), " on");
}
} // namespace Voussoir
