// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/floating_point.h>
#include <voussoir/packing/polyhedra/models/check_surface.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/intersections.h>
#include <boost/variant.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace Voussoir
{
using DefectKind = ModelDefect::Kind;

namespace
{
using CrossingKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CrossingPlace = CrossingKernel::Point_3;
using TriangleMesh = CGAL::Surface_mesh<CrossingPlace>;
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

/**
 * With assertions CGAL warns of slow triangulations of faces that are hardly
 * planar, on the terminal; they are few.
 */
void keep_silent(const char * /*kind*/,
                 const char * /*expression*/,
                 const char * /*file*/,
                 int /*line*/,
                 const char * /*explanation*/)
{}

/**
 * Cut the faces that CGAL does not find triangles of, as warped or very slender
 * ones, from one vertex; those triangles meet there, and do not count as
 * crossing each other.
 */
void cut_remaining_faces(TriangleMesh &mesh)
{
  std::vector<TriangleMesh::Face_index> remaining;
  for (const TriangleMesh::Face_index face : mesh.faces())
    if (mesh.degree(face) > 3)
      remaining.push_back(face);
  for (const TriangleMesh::Face_index face : remaining)
  {
    const TriangleMesh::Halfedge_index h = mesh.halfedge(face);
    while (mesh.next(mesh.next(mesh.next(h))) != h)
      CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
  }
}

TriangleMesh triangles_of(const Surface &surface)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<CrossingPlace> places;
  for (const dealii::Point<3> &p : surface.vertices)
    places.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> loops;
  for (unsigned int f = 0; f < surface.faces.size(); ++f)
    loops.emplace_back(surface.faces[f].begin(), surface.faces[f].end());
  TriangleMesh mesh;
  PMP::orient_polygon_soup(places, loops); // doubles vertices of two fans
  PMP::polygon_soup_to_polygon_mesh(places, loops, mesh);
  static const bool is_silent =
      CGAL::set_warning_handler(keep_silent) != nullptr;
  static_cast<void>(is_silent);
  PMP::triangulate_faces(mesh);
  cut_remaining_faces(mesh);
  return mesh;
}

CrossingTriangle corners_of_triangle(const TriangleMesh &mesh,
                                     const TriangleMesh::Face_index face)
{
  CrossingTriangle triangle;
  auto halfedge = mesh.halfedge(face);
  for (CrossingPlace &corner : triangle)
  {
    corner = mesh.point(mesh.target(halfedge));
    halfedge = mesh.next(halfedge);
  }
  return triangle;
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

/** The longest distance within the intersection of triangles, and where. */
std::pair<double, CrossingPlace> extent_of_crossing(const CrossingTriangle &a,
                                                    const CrossingTriangle &b)
{
  const CGAL::Cartesian_converter<CrossingKernel, ExactKernel> exact;
  const CGAL::Cartesian_converter<ExactKernel, CrossingKernel> rounded;
  const auto triangle = [&](const CrossingTriangle &t) {
    return ExactKernel::Triangle_3(exact(t[0]), exact(t[1]), exact(t[2]));
  };
  const auto crossing = CGAL::intersection(triangle(a), triangle(b));
  std::pair<double, CrossingPlace> extent = {0., a[0]};
  if (!crossing)
    return extent;
  std::vector<CrossingPlace> points;
  for (const ExactPlace &p :
       boost::apply_visitor(PointsOfIntersection(), *crossing))
  {
    CGAL::exact(p); // Its interval is a rounded place from then on.
    points.push_back(rounded(p));
  }
  for (const CrossingPlace &p : points)
    for (const CrossingPlace &q : points)
      if (const double length = std::sqrt(CGAL::squared_distance(p, q));
          length > extent.first)
        extent = {length, CGAL::midpoint(p, q)};
  return extent;
}
} // namespace

void check_crossings(MendedSurface &mended, const double distance)
{
  if (is_convex_surface(mended.surface, distance))
    return;
  const InvalidOperationsAllowed allowed;
  const TriangleMesh mesh = triangles_of(mended.surface);
  std::vector<std::pair<TriangleMesh::Face_index, TriangleMesh::Face_index>>
      pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh,
                                                    std::back_inserter(pairs));
  ModelDefect found = {DefectKind::crossing_surface};
  found.count = 0;
  for (const auto &[f, g] : pairs)
  {
    const CrossingTriangle a = corners_of_triangle(mesh, f),
                           b = corners_of_triangle(mesh, g);
    if (std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end())
      continue;
    const auto [length, place] = extent_of_crossing(a, b);
    if (length <= distance)
      continue;
    ++found.count;
    if (length > found.size)
    {
      found.size = length;
      // Without the sign of a zero.
      found.place = {place.x() + 0., place.y() + 0., place.z() + 0.};
    }
  }
  if (found.count > 0)
    mended.defects.push_back(found);
}
} // namespace Voussoir
