// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/floating_point.h>
#include <voussoir/packing/cgal_result.h>
#include <voussoir/packing/polyhedra/face_triangles.h>
#include <voussoir/packing/polyhedra/models/check_surface.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
using DefectKind = ModelDefect::Kind;

namespace
{
using CrossingKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CrossingPlace = CrossingKernel::Point_3;
using CrossingTriangle = std::array<CrossingPlace, 3>;
/** Of intersections: those of triangles in one plane are found from points that
 * are found before, which are no numbers where lines are nearly parallel. */
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPlace = ExactKernel::Point_3;

/** True if no vertex is further out of a face than @p distance. */
bool is_convex_surface(const Surface &surface, const double distance)
{
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
  {
    const SurfacePlane plane = plane_of(surface, f);
    const double area = plane.vector_area.norm();
    for (const unsigned int v : surface.faces.corners)
      if (plane.vector_area * (surface.vertices[v] - plane.place) >
          distance * area)
        return false;
  }
  return true;
}

/** A triangle of a face. */
struct PartOfFace
{
  CrossingTriangle corners;
  unsigned int face;
};

/** The triangles of all faces that have an area. */
std::vector<PartOfFace> parts_of_faces(const Surface &surface)
{
  CellFaces cell;
  cell.vertices = surface.vertices;
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
    cell.add_face(surface.faces[f]);
  std::vector<PartOfFace> parts;
  for (unsigned int f = 0; f < cell.n_faces(); ++f)
    for (const std::array<unsigned int, 3> &corners : triangles_of(cell, f))
    {
      CrossingTriangle triangle;
      for (unsigned int i = 0; i < 3; ++i)
      {
        const dealii::Point<3> &p = cell.vertex(f, corners[i]);
        triangle[i] = {p[0], p[1], p[2]};
      }
      if (!CGAL::collinear(triangle[0], triangle[1], triangle[2]))
        parts.push_back({triangle, f});
    }
  return parts;
}

bool have_common_corner(const CrossingTriangle &a, const CrossingTriangle &b)
{
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

/** Whether all corners of @p b that are none of @p a are on one side of its
 * plane, and not in it. */
bool is_on_one_side(const CrossingTriangle &a, const CrossingTriangle &b)
{
  CGAL::Orientation side = CGAL::COPLANAR;
  for (const CrossingPlace &p : b)
  {
    if (std::find(a.begin(), a.end(), p) != a.end())
      continue;
    const CGAL::Orientation of_corner = CGAL::orientation(a[0], a[1], a[2], p);
    if (of_corner == CGAL::COPLANAR ||
        (side != CGAL::COPLANAR && of_corner != side))
      return false;
    side = of_corner;
  }
  return side != CGAL::COPLANAR;
}

/** Whether triangles look to opposite sides: those of a face that is warped
 * within the tolerance may cross its neighbours', which look about as it does.
 */
bool is_folded(const CrossingTriangle &a, const CrossingTriangle &b)
{
  return CGAL::cross_product(a[1] - a[0], a[2] - a[0]) *
             CGAL::cross_product(b[1] - b[0], b[2] - b[0]) <
         0.;
}

/** Call @p f for the triangles of any two faces that may have more in common
 * than corners, or than a side. */
template <typename F>
void for_each_crossing(const std::vector<PartOfFace> &parts, const F &f)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < parts.size(); ++k)
    boxes.emplace_back(
        CGAL::bbox_3(parts[k].corners.begin(), parts[k].corners.end()), k);
  const auto look_at = [&](const Box &one, const Box &other) {
    const PartOfFace &first = parts[one.info()], &second = parts[other.info()];
    const CrossingTriangle &a = first.corners, &b = second.corners;
    if (first.face == second.face || is_on_one_side(a, b) ||
        is_on_one_side(b, a))
      return;
    if (have_common_corner(a, b)
            ? is_folded(a, b)
            : CGAL::do_intersect(CrossingKernel::Triangle_3(a[0], a[1], a[2]),
                                 CrossingKernel::Triangle_3(b[0], b[1], b[2])))
      f(first, second);
  };
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), look_at);
}

/** The points that an intersection of triangles is the hull of. */
struct PointsOfIntersection
{
  using Points = std::vector<ExactPlace>;
  Points operator()(const ExactPlace &p) const { return {p}; }
  Points operator()(const ExactKernel::Segment_3 &s) const
  {
    return {s.source(), s.target()};
  }
  Points operator()(const ExactKernel::Triangle_3 &t) const
  {
    return {t[0], t[1], t[2]};
  }
  Points operator()(const Points &points) const { return points; }
};

/** The points of which the intersection of triangles is the hull. */
std::vector<CrossingPlace> common_points(const CrossingTriangle &a,
                                         const CrossingTriangle &b)
{
  const CGAL::Cartesian_converter<CrossingKernel, ExactKernel> exact;
  const CGAL::Cartesian_converter<ExactKernel, CrossingKernel> rounded;
  const auto triangle = [&](const CrossingTriangle &t) {
    return ExactKernel::Triangle_3(exact(t[0]), exact(t[1]), exact(t[2]));
  };
  const auto crossing = CGAL::intersection(triangle(a), triangle(b));
  std::vector<CrossingPlace> points;
  if (!crossing)
    return points;
  for (const ExactPlace &p : visit_result(PointsOfIntersection(), *crossing))
  {
    CGAL::exact(p); // Its interval is a rounded place from then on.
    points.push_back(rounded(p));
  }
  return points;
}

/** The longest distance between points, and its middle. */
struct CrossingExtent
{
  double length = 0.;
  CrossingPlace middle;
};

CrossingExtent extent_of(const std::vector<CrossingPlace> &points)
{
  CrossingExtent extent;
  for (const CrossingPlace &p : points)
    for (const CrossingPlace &q : points)
      if (const double length = std::sqrt(CGAL::squared_distance(p, q));
          length > extent.length)
        extent = {length, CGAL::midpoint(p, q)};
  return extent;
}

/** The distance of a point from the sides of a face. */
double distance_from_sides(const Surface &surface,
                           const unsigned int face,
                           const CrossingPlace &p)
{
  const auto place = [&](const unsigned int v) {
    const dealii::Point<3> &at = surface.vertices[v];
    return CrossingPlace(at[0], at[1], at[2]);
  };
  double least = std::numeric_limits<double>::infinity();
  const auto &loop = surface.faces[face];
  for (unsigned int i = 0; i < loop.size(); ++i)
    least = std::min(
        least, CGAL::squared_distance(
                   p, CrossingKernel::Segment_3(
                          place(loop[i]), place(loop[(i + 1) % loop.size()]))));
  return std::sqrt(least);
}

/** How far within one of two faces the middles between points are. */
double depth_of(const std::vector<CrossingPlace> &points,
                const Surface &surface,
                const unsigned int one,
                const unsigned int other)
{
  double depth = 0.;
  for (const CrossingPlace &p : points)
    for (const CrossingPlace &q : points)
      for (const unsigned int face : {one, other})
        depth = std::max(
            depth, distance_from_sides(surface, face, CGAL::midpoint(p, q)));
  return depth;
}

/** Whether two faces have a vertex in common. */
bool are_neighbours(const Surface &surface,
                    const unsigned int one,
                    const unsigned int other)
{
  const auto &a = surface.faces[one], &b = surface.faces[other];
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}
} // namespace

void check_crossings(MendedSurface &mended, const double distance)
{
  if (is_convex_surface(mended.surface, distance))
    return;
  const InvalidOperationsAllowed allowed;
  ModelDefect found = {DefectKind::crossing_surface};
  found.count = 0;
  CrossingExtent worst;
  const Surface &surface = mended.surface;
  const auto look_at = [&](const PartOfFace &a, const PartOfFace &b) {
    const std::vector<CrossingPlace> points =
        common_points(a.corners, b.corners);
    const CrossingExtent extent = extent_of(points);
    // Neighbours that are warped within the tolerance may cross beside the
    // side that they have in common.
    if (extent.length <= distance ||
        (are_neighbours(surface, a.face, b.face) &&
         depth_of(points, surface, a.face, b.face) <= distance))
      return;
    ++found.count;
    // Of equal ones the first by its place.
    if (extent.length > worst.length ||
        (extent.length == worst.length &&
         CGAL::lexicographically_xyz_smaller(extent.middle, worst.middle)))
      worst = extent;
  };
  for_each_crossing(parts_of_faces(surface), look_at);
  if (found.count == 0)
    return;
  found.size = worst.length;
  // Without the sign of a zero.
  const CrossingPlace &place = worst.middle;
  found.place = {place.x() + 0., place.y() + 0., place.z() + 0.};
  mended.defects.push_back(found);
}
} // namespace Voussoir
