// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/invalid_index.h>
#include <voussoir/packing/voronoi/cell_cutter.h>
#include <voussoir/packing/voronoi/voronoi_cells.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
using dealii::Point;

/**
 * Vertices and generators nearer to each other than this, relative to the mean
 * size of a cell, are taken for the same point.
 */
constexpr double relative_resolution = 1e-12;

/**
 * The distance of the guards, relative to the size of the polygon: farther than
 * any point of it is from a generator, by more than that distance again.
 */
constexpr double guard_distance = 4.;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_2<unsigned int, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<unsigned int, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

/**
 * The height of a triangle over its longest side below which its circumcentre
 * is computed with rational numbers: the error of the plain formula grows with
 * the inverse of that ratio.
 */
constexpr double slender_triangle = 0.05;

/** The circumcentre of a finite face, right to rounding whatever its shape. */
Point<2> circumcentre(const Delaunay::Face_handle &face)
{
  const Kernel::Point_2 &a = face->vertex(0)->point();
  const Kernel::Point_2 &b = face->vertex(1)->point();
  const Kernel::Point_2 &c = face->vertex(2)->point();
  const double longest =
      std::max({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c),
                CGAL::squared_distance(c, a)});
  if (2. * CGAL::area(a, b, c) > slender_triangle * longest)
  {
    const Kernel::Point_2 q = CGAL::circumcenter(a, b, c);
    return {q.x(), q.y()};
  }
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const CGAL::Cartesian_converter<Kernel, Exact> exact;
  const Exact::Point_2 q = CGAL::circumcenter(exact(a), exact(b), exact(c));
  return {CGAL::to_double(q.x()), CGAL::to_double(q.y())};
}

/** Builds the cells; one object, used once. */
class VoronoiBuilder
{
public:
  VoronoiBuilder(const PointList<2> &generators, const ConvexPolygon &polygon)
      : generators(generators), polygon(polygon)
  {
    const double cell_size =
        std::sqrt(polygon.area() / generators.points.size());
    double largest_coordinate = 0.;
    for (unsigned int i = 0; i < polygon.n_sides(); ++i)
    {
      extent =
          std::max(extent, 2. * polygon.vertex(i).distance(polygon.vertex(0)));
      for (unsigned int d = 0; d < 2; ++d)
        largest_coordinate =
            std::max(largest_coordinate, std::abs(polygon.vertex(i)[d]));
    }
    resolution = std::max(relative_resolution * cell_size,
                          16 * std::numeric_limits<double>::epsilon() *
                              largest_coordinate);
  }

  CellLoops build()
  {
    check_generators();
    insert_generators();
    insert_guards();
    make_vertices();
    make_loops();
    triangulation.clear(); // the larger part of the memory
    return number_vertices();
  }

private:
  void check_generators() const
  {
    for (unsigned int c = 0; c < generators.points.size(); ++c)
      if (!polygon.contains(generators.points[c], resolution))
        throw InputError("The " + generators.describe(c) +
                         " is not inside the " + polygon.description() +
                         "; remove it or enlarge the " + polygon.shape() + ".");
  }

  void insert_generators()
  {
    const unsigned int n = generators.points.size();
    std::vector<std::pair<Kernel::Point_2, unsigned int>> sites(n);
    for (unsigned int c = 0; c < n; ++c)
      sites[c] = {
          Kernel::Point_2(generators.points[c][0], generators.points[c][1]), c};
    triangulation.insert(sites.begin(), sites.end());

    const auto refuse = [this](const unsigned int a, const unsigned int b) {
      throw InputError("The " + generators.describe(std::max(a, b)) +
                       " coincides with " +
                       generators.describe(std::min(a, b)) +
                       "; each cell needs a point of its own.");
    };
    site_of_cell.assign(n, nullptr);
    for (const auto vertex : triangulation.finite_vertex_handles())
      site_of_cell[vertex->info()] = vertex;
    for (unsigned int c = 0; c < n; ++c)
      if (site_of_cell[c] == nullptr) // it fell onto an earlier point
        refuse(c, triangulation.nearest_vertex(sites[c].first)->info());
    // The nearest neighbour of a point is one of its Delaunay neighbours.
    for (const auto &edge : triangulation.finite_edges())
    {
      const auto a = edge.first->vertex(Delaunay::cw(edge.second));
      const auto b = edge.first->vertex(Delaunay::ccw(edge.second));
      if (CGAL::squared_distance(a->point(), b->point()) <
          resolution * resolution)
        refuse(a->info(), b->info());
    }
  }

  /** Make all cells finite, and change none inside the polygon. */
  void insert_guards()
  {
    const unsigned int n_guards = 3;
    for (unsigned int g = 0; g < n_guards; ++g)
    {
      const double angle = 2. * dealii::numbers::PI * g / n_guards;
      const Point<2> &origin = polygon.vertex(0);
      triangulation
          .insert(Kernel::Point_2(
              origin[0] + guard_distance * extent * std::cos(angle),
              origin[1] + guard_distance * extent * std::sin(angle)))
          ->info() = invalid_index;
    }
  }

  void make_vertices()
  {
    raw.vertices.reserve(triangulation.number_of_faces());
    outside.reserve(triangulation.number_of_faces());
    for (const auto face : triangulation.finite_face_handles())
    {
      face->info() = raw.vertices.size();
      raw.vertices.push_back(circumcentre(face));
      outside.push_back(!polygon.contains(raw.vertices.back(), 0.));
    }
    n_sides_at.assign(raw.vertices.size(), 0);
  }

  void make_loops()
  {
    CellCutter cutter(polygon, generators.points, raw.vertices.size());
    raw.loops.reserve(
        3 * raw.vertices.size()); // each in three cells, but at the sides
    raw.first.reserve(site_of_cell.size() + 1);
    for (unsigned int c = 0; c < site_of_cell.size(); ++c)
    {
      std::vector<CellCutter::Corner> corners = corners_of(site_of_cell[c]);
      if (std::any_of(corners.begin(), corners.end(), [&](const auto &corner) {
            return outside[corner.vertex];
          }))
        cutter.cut(c, corners);
      for (const CellCutter::Corner &corner : corners)
        raw.loops.push_back(corner.vertex);
      raw.first.push_back(raw.loops.size());
    }
    for (const CellCutter::Vertex &vertex : cutter.made_vertices())
    {
      raw.vertices.push_back(vertex.position);
      n_sides_at.push_back(vertex.n_sides);
    }
  }

  /** The cell of a site in the whole plane, counterclockwise. */
  std::vector<CellCutter::Corner>
  corners_of(const Delaunay::Vertex_handle site) const
  {
    std::vector<CellCutter::Corner> corners;
    Delaunay::Face_circulator face = triangulation.incident_faces(site);
    const Delaunay::Face_circulator begin = face;
    do
    {
      CellCutter::Corner corner;
      corner.vertex = face->info();
      corner.position = raw.vertices[corner.vertex];
      corner.neighbour = face->vertex(Delaunay::cw(face->index(site)))
                             ->info(); // none: a guard
      corners.push_back(corner);
    } while (++face != begin);
    return corners;
  }

  /** For each vertex the one that stands for all that are the same point. */
  std::vector<unsigned int> merge_close_vertices() const
  {
    const unsigned int n = raw.vertices.size();
    boost::disjoint_sets_with_storage<> sets(n);
    for (unsigned int c = 0; c < raw.n_cells(); ++c)
      for (unsigned int i = 0; i < raw.n_sides(c); ++i)
        if (raw.vertex(c, i).distance(raw.vertex(c, i + 1)) <= resolution)
          sets.union_set(raw.corner(c, i), raw.corner(c, i + 1));

    // Of the vertices in a set, keep the one that lies on most sides.
    std::vector<unsigned int> kept(n, invalid_index), merged_into(n);
    for (unsigned int v = 0; v < n; ++v)
    {
      unsigned int &k = kept[sets.find_set(v)];
      if (k == invalid_index || n_sides_at[v] > n_sides_at[k])
        k = v;
    }
    for (unsigned int v = 0; v < n; ++v)
      merged_into[v] = kept[sets.find_set(v)];
    return merged_into;
  }

  CellLoops number_vertices() const
  {
    const std::vector<unsigned int> merged_into = merge_close_vertices();
    CellLoops cells;
    cells.centres = generators.points;
    cells.vertices.reserve(raw.vertices.size());
    cells.loops.reserve(raw.loops.size());
    cells.first.reserve(raw.first.size());
    std::vector<unsigned int> number(raw.vertices.size(), invalid_index);
    for (unsigned int c = 0; c < raw.n_cells(); ++c)
    {
      for (unsigned int i = 0; i < raw.n_sides(c); ++i)
      {
        const unsigned int v = merged_into[raw.corner(c, i)];
        if (v == merged_into[raw.corner(c, i + raw.n_sides(c) - 1)])
          continue;
        if (number[v] == invalid_index)
        {
          number[v] = cells.vertices.size();
          cells.vertices.push_back(raw.vertices[v]);
        }
        cells.loops.push_back(number[v]);
      }
      cells.first.push_back(cells.loops.size());
    }
    return cells;
  }

  const PointList<2> &generators;
  const ConvexPolygon &polygon;
  /** The distance below which points are the same; a length. */
  double resolution = 0.;
  /** A number larger than the size of the polygon; a length. */
  double extent = 0.;

  Delaunay triangulation;
  std::vector<Delaunay::Vertex_handle> site_of_cell;
  /** The cells with all vertices, also those that are the same point. */
  CellLoops raw;
  /** Of the vertices of the triangulation's faces, those not inside. */
  std::vector<bool> outside;
  /** The number of sides of the polygon on which each vertex lies. */
  std::vector<unsigned char> n_sides_at;
};
} // namespace

CellLoops voronoi_cells(const PointList<2> &generators,
                        const ConvexPolygon &polygon)
{
  return VoronoiBuilder(generators, polygon).build();
}
} // namespace Voussoir
