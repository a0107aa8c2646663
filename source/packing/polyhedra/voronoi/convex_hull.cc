// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/invalid_index.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/voronoi/convex_hull.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/tensor.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

/**
 * Corners nearer to a plane than this, relative to the size of the hull, lie in
 * it: far above rounding, so that no face is an accident of it, and far below
 * any face that is meant.
 */
constexpr double flattest_edge = 1e-9;

using HullKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using HullMesh = CGAL::Surface_mesh<HullKernel::Point_3>;
using HullFace = HullMesh::Face_index;

double size_of_hull(const std::vector<Point<3>> &points)
{
  const dealii::BoundingBox<3> box(points);
  return std::max({box.side_length(0), box.side_length(1), box.side_length(2)});
}

/**
 * The largest distance of @p points from the plane through the first one, that
 * farthest from it, and that farthest from the line through these two.
 */
double thickness_of(const std::vector<Point<3>> &points)
{
  Tensor<1, 3> along, across;
  double thickness = 0.;
  for (const Point<3> &p : points)
    if ((p - points[0]).norm() > along.norm())
      along = p - points[0];
  if (along.norm() == 0.)
    return 0.;
  along /= along.norm();
  for (const Point<3> &p : points)
  {
    const Tensor<1, 3> arm = cross_product_3d(along, p - points[0]);
    if (arm.norm() > across.norm())
      across = arm;
  }
  if (across.norm() == 0.)
    return 0.;
  across /= across.norm();
  for (const Point<3> &p : points)
    thickness = std::max(thickness, std::abs(across * (p - points[0])));
  return thickness;
}

/** Joins the triangles of a hull to faces; one object, used once. */
class HullFaces
{
public:
  HullFaces(const HullMesh &mesh, const double size)
      : mesh(mesh), tolerance(flattest_edge * size),
        group(mesh.number_of_faces(), invalid_index)
  {}

  /** Vertex numbers of the mesh around each face, all of which are corners. */
  std::vector<std::vector<unsigned int>> loops()
  {
    std::vector<std::pair<double, HullFace>> by_area;
    for (const HullFace face : mesh.faces())
      by_area.emplace_back(-vector_area(face).norm(), face);
    std::sort(by_area.begin(), by_area.end());
    unsigned int n_groups = 0;
    for (const auto &[minus_area, face] : by_area)
      if (group[face] == invalid_index)
        spread(face, n_groups++);

    std::vector<std::vector<unsigned int>> loops = outlines(n_groups);
    drop_what_is_no_corner(loops);
    return loops;
  }

private:
  Point<3> place(const HullMesh::Vertex_index v) const
  {
    const HullKernel::Point_3 &p = mesh.point(v);
    return {p.x(), p.y(), p.z()};
  }

  Tensor<1, 3> vector_area(const HullFace face) const
  {
    Tensor<1, 3> sum;
    const auto first = mesh.halfedge(face);
    const Point<3> origin = place(mesh.source(first));
    for (const auto h : mesh.halfedges_around_face(first))
      sum += 0.5 * cross_product_3d(place(mesh.source(h)) - origin,
                                    place(mesh.target(h)) - origin);
    return sum;
  }

  /** Put into a group @p face and all around it that lie in its plane. */
  void spread(const HullFace face, const unsigned int g)
  {
    const Tensor<1, 3> area = vector_area(face);
    const Tensor<1, 3> normal = area / area.norm();
    const Point<3> origin = place(mesh.source(mesh.halfedge(face)));
    const auto is_in_plane = [&](const HullFace f) {
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        if (std::abs(normal * (place(v) - origin)) > tolerance)
          return false;
      return true;
    };
    std::vector<HullFace> open = {face};
    group[face] = g;
    while (!open.empty())
    {
      const HullFace f = open.back();
      open.pop_back();
      for (const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
      {
        const HullFace next = mesh.face(mesh.opposite(h));
        if (group[next] != invalid_index || !is_in_plane(next))
          continue;
        group[next] = g;
        open.push_back(next);
      }
    }
  }

  /** Vertices around the faces of each group. */
  std::vector<std::vector<unsigned int>>
  outlines(const unsigned int n_groups) const
  {
    std::vector<std::map<unsigned int, unsigned int>> next(n_groups);
    for (const auto h : mesh.halfedges())
    {
      const unsigned int g = group[mesh.face(h)];
      if (group[mesh.face(mesh.opposite(h))] != g)
        next[g][mesh.source(h)] = mesh.target(h);
    }
    std::vector<std::vector<unsigned int>> loops(n_groups);
    for (unsigned int g = 0; g < n_groups; ++g)
      for (unsigned int v = next[g].begin()->first;
           loops[g].size() < next[g].size(); v = next[g][v])
        loops[g].push_back(v);
    return loops;
  }

  /** Of the @p loops, keep the vertices that three or more have. */
  void drop_what_is_no_corner(std::vector<std::vector<unsigned int>> &loops)
  {
    std::vector<unsigned int> n_loops(mesh.number_of_vertices(), 0);
    for (const auto &loop : loops)
      for (const unsigned int v : loop)
        ++n_loops[v];
    for (auto &loop : loops)
      loop.erase(
          std::remove_if(loop.begin(), loop.end(),
                         [&](const unsigned int v) { return n_loops[v] < 3; }),
          loop.end());
  }

  const HullMesh &mesh;
  const double tolerance;
  /** For each triangle its face's number. */
  std::vector<unsigned int> group;
};
} // namespace

CellFaces convex_hull(const std::vector<Point<3>> &points)
{
  if (points.size() < 4)
    throw InputError(text("The polyhedron has ",
                          counted(points.size(), "point"),
                          "; it needs at least four."));
  const double size = size_of_hull(points);
  if (!(thickness_of(points) > flattest_edge * size))
    throw InputError(text("The polyhedron with ", points.size(),
                          " points from ", text_of_point(points[0]),
                          " on is flat: its points lie in one plane; give the "
                          "corners around a positive volume."));
  std::vector<HullKernel::Point_3> given;
  std::map<HullKernel::Point_3, unsigned int> first;
  for (unsigned int i = 0; i < points.size(); ++i)
  {
    given.emplace_back(points[i][0], points[i][1], points[i][2]);
    first.emplace(given.back(), i);
  }
  HullMesh mesh;
  CGAL::convex_hull_3(given.begin(), given.end(), mesh);

  std::vector<std::vector<unsigned int>> loops = HullFaces(mesh, size).loops();
  std::vector<unsigned int> number(points.size(), invalid_index);
  for (auto &loop : loops)
  {
    for (unsigned int &v : loop)
    {
      v = first.at(mesh.point(HullMesh::Vertex_index(v)));
      number[v] = 0;
    }
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()),
                loop.end());
  }
  std::sort(loops.begin(), loops.end());

  CellFaces hull;
  for (unsigned int i = 0; i < points.size(); ++i)
    if (number[i] == 0)
    {
      number[i] = hull.vertices.size();
      hull.vertices.push_back(points[i]);
    }
  for (auto &loop : loops)
  {
    for (unsigned int &v : loop)
      v = number[v];
    hull.add_face(loop);
  }
  hull.end_cell();
  return hull;
}
} // namespace Voussoir
