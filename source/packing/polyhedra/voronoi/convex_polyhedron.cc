// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/invalid_index.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/cell_moments.h>
#include <voussoir/packing/polyhedra/space_polygons.h>
#include <voussoir/packing/polyhedra/voronoi/convex_hull.h>
#include <voussoir/packing/polyhedra/voronoi/convex_polyhedron.h>

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
/** The size of a domain with whose fifth powers one can compute. */
constexpr double smallest_size = 1e-50, largest_size = 1e50;

/**
 * The part of the distance to the nearest plane within which a point is inside
 * without a look at the planes: one, less a rest far above rounding.
 */
constexpr double part_of_inner_radius = 0.999;

/** @throws InputError unless all @p points can be computed with. */
void check_places(const std::vector<Point<3>> &points, const std::string &what)
{
  for (unsigned int i = 0; i < points.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      if (!std::isfinite(points[i][d]))
        throw InputError(text("Point ", i, " of the ", what, ", at ",
                              text_of_point(points[i]),
                              ", is not finite; give three numbers \"x, y, "
                              "z\"."));
  double size = 0., largest = 0.;
  for (const Point<3> &p : points)
    for (unsigned int d = 0; d < 3; ++d)
    {
      size = std::max(size, std::abs(p[d] - points[0][d]));
      largest = std::max(largest, std::abs(p[d]));
    }
  // One point, once or often, is for convex_hull() to refuse.
  if ((size > 0. && size < smallest_size) || largest > largest_size)
    throw InputError(text("The ", what, " from ", text_of_point(points[0]),
                          " to ", text_of_point(points.back()),
                          " is too large or too small to compute with; choose "
                          "a unit of length in which it is between ",
                          smallest_size, " and ", largest_size, "."));
}

/** Vertex numbers bit by bit: x, then y, then z of the upper corner. */
constexpr std::array<std::array<unsigned int, 4>, 6> loops_of_box = {
    {{{0, 4, 6, 2}},
     {{1, 3, 7, 5}},
     {{0, 1, 5, 4}},
     {{2, 6, 7, 3}},
     {{0, 2, 3, 1}},
     {{4, 5, 7, 6}}}};
} // namespace

ConvexPolyhedron::ConvexPolyhedron(const std::vector<Point<3>> &points)
    : shape_name("polyhedron")
{
  check_places(points, shape_name);
  surface = convex_hull(points);
  measure();
}

ConvexPolyhedron::ConvexPolyhedron(const Box &box) : shape_name("box")
{
  check_places({box.lower, box.upper}, shape_name);
  for (unsigned int i = 0; i < 8; ++i)
  {
    Point<3> corner;
    for (unsigned int d = 0; d < 3; ++d)
      corner[d] = i >> d & 1 ? box.upper[d] : box.lower[d];
    surface.vertices.push_back(corner);
  }
  for (const auto &face : loops_of_box)
    surface.add_face(face);
  surface.end_cell();
  measure();
}

void ConvexPolyhedron::measure()
{
  const dealii::BoundingBox<3> box(surface.vertices);
  for (unsigned int d = 0; d < 3; ++d)
    longest = std::max(longest, box.side_length(d));
  const CellMoments moments = moments_of(surface, 0);
  volume_inside = moments.volume;
  centroid = moments.centroid;
  for (unsigned int k = 0; k < surface.n_faces(); ++k)
    planes.push_back(plane_of(k));
  inner_radius = std::numeric_limits<double>::infinity();
  for (unsigned int k = 0; k < n_planes(); ++k)
    inner_radius =
        std::min(inner_radius, -part_of_inner_radius * beyond(centroid, k));
}

/** Through the corners that make a large triangle. */
ConvexPolyhedron::Plane
ConvexPolyhedron::plane_of(const unsigned int face) const
{
  Plane plane;
  plane.axis = invalid_index;
  const auto corners = surface.corners(face);
  const auto at = [&](const unsigned int i) -> const Point<3> & {
    return surface.vertices[corners[i]];
  };
  // In order around the face, so that the normal points outwards.
  std::array<unsigned int, 3> best = {{0, 1, 2}};
  double largest = 0.;
  for (unsigned int i = 1; i < corners.size(); ++i)
    if (at(i).distance(at(0)) > largest)
    {
      largest = at(i).distance(at(0));
      best[1] = i;
    }
  largest = 0.;
  for (unsigned int i = 1; i < corners.size(); ++i)
  {
    const double area =
        cross_product_3d(at(best[1]) - at(0), at(i) - at(0)).norm();
    if (area > largest)
    {
      largest = area;
      best[2] = i;
    }
  }
  if (best[2] < best[1])
    std::swap(best[1], best[2]);
  for (unsigned int i = 0; i < 3; ++i)
    plane.corners[i] = corners[best[i]];
  plane.normal =
      cross_product_3d(at(best[1]) - at(0), at(best[2]) - at(0)) / largest;
  for (unsigned int d = 0; d < 3; ++d)
    if (std::all_of(corners.begin(), corners.end(), [&](const unsigned int v) {
          return surface.vertices[v][d] == at(0)[d];
        }))
    {
      plane.axis = d;
      for (unsigned int e = 0; e < 3; ++e)
        plane.normal[e] = e == d ? std::copysign(1., plane.normal[d]) : 0.;
    }
  return plane;
}

double ConvexPolyhedron::largest_length() const
{
  double largest = extent();
  for (const Point<3> &corner : surface.vertices)
    for (unsigned int d = 0; d < 3; ++d)
      largest = std::max(largest, std::abs(corner[d]));
  return largest;
}

unsigned int
ConvexPolyhedron::corner_in(const std::array<unsigned int, 3> &planes) const
{
  const auto is_in = [&](const unsigned int v, const unsigned int k) {
    const auto corners = surface.corners(k);
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  };
  for (const unsigned int v : surface.corners(planes[0]))
    if (is_in(v, planes[1]) && is_in(v, planes[2]))
      return v;
  return invalid_index;
}

bool ConvexPolyhedron::contains(const Point<3> &p, const double margin) const
{
  if (p.distance(centroid) < inner_radius - margin)
    return true;
  for (unsigned int k = 0; k < n_planes(); ++k)
    if (!(beyond(p, k) < -margin))
      return false;
  return true;
}

std::string ConvexPolyhedron::description() const
{
  const auto &corners = surface.vertices;
  if (shape_name == "box")
    return "box from " + text_of_point(corners.front()) + " to " +
           text_of_point(corners.back());
  return text("polyhedron with ", n_planes(), " faces and ", corners.size(),
              " corners from ", text_of_point(corners[0]), " on");
}
} // namespace Voussoir
