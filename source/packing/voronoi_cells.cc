// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/voronoi_cells.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
using dealii::Point;

constexpr unsigned int none = dealii::numbers::invalid_unsigned_int;

/**
 * Vertices and generators nearer to each other than this, relative to the mean
 * size of a cell, are taken for the same point.
 */
constexpr double relative_resolution = 1e-12;

/** The sides of the rectangle: left, right, bottom, top. */
constexpr unsigned int n_rectangle_sides = 4;
using SideSet = std::bitset<n_rectangle_sides>;

/** What a vertex of the triangulation is: a generator, or its mirror image. */
struct Site
{
  unsigned int cell = none;
  unsigned int mirrored_in = none;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Site, Kernel>;
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
  VoronoiBuilder(const PointList &generators, const Rectangle &rectangle);
  CellLoops build();

private:
  double side_coordinate(unsigned int side) const;
  /** How far @p p lies beyond a side; negative inside. */
  double beyond(const Point<2> &p, unsigned int side) const;
  void check_generators() const;
  void insert_generators();
  void insert_mirror_images();
  void make_vertices();
  void merge_close_vertices();
  CellLoops make_loops();

  const PointList &generators;
  const Rectangle &rectangle;
  double resolution = 0.;

  Delaunay triangulation;
  std::vector<Delaunay::Vertex_handle> site_of_cell;
  std::vector<Point<2>> vertices;
  std::vector<SideSet> vertex_sides;
  std::vector<unsigned int> merged_into;
};

VoronoiBuilder::VoronoiBuilder(const PointList &generators,
                               const Rectangle &rectangle)
    : generators(generators), rectangle(rectangle)
{
  const double cell_size =
      std::sqrt(rectangle.area() / generators.points.size());
  double largest_coordinate = 0.;
  for (const Point<2> &corner : {rectangle.lower_left, rectangle.upper_right})
    for (unsigned int i = 0; i < 2; ++i)
      largest_coordinate = std::max(largest_coordinate, std::abs(corner[i]));
  resolution = std::max(relative_resolution * cell_size,
                        16 * std::numeric_limits<double>::epsilon() *
                            largest_coordinate);
}

CellLoops VoronoiBuilder::build()
{
  check_generators();
  insert_generators();
  insert_mirror_images();
  make_vertices();
  merge_close_vertices();
  return make_loops();
}

double VoronoiBuilder::side_coordinate(const unsigned int side) const
{
  return (side % 2 == 0 ? rectangle.lower_left
                        : rectangle.upper_right)[side / 2];
}

double VoronoiBuilder::beyond(const Point<2> &p, const unsigned int side) const
{
  const double distance = p[side / 2] - side_coordinate(side);
  return side % 2 == 0 ? -distance : distance;
}

void VoronoiBuilder::check_generators() const
{
  for (unsigned int c = 0; c < generators.points.size(); ++c)
    for (unsigned int side = 0; side < n_rectangle_sides; ++side)
      if (!(beyond(generators.points[c], side) < -resolution))
        throw InputError("The " + generators.describe(c) +
                         " is not inside the rectangle from " +
                         text_of_point(rectangle.lower_left) + " to " +
                         text_of_point(rectangle.upper_right) +
                         "; remove it or enlarge the rectangle.");
}

void VoronoiBuilder::insert_generators()
{
  const unsigned int n = generators.points.size();
  std::vector<std::pair<Kernel::Point_2, Site>> sites(n);
  for (unsigned int c = 0; c < n; ++c)
    sites[c] = {
        Kernel::Point_2(generators.points[c][0], generators.points[c][1]),
        Site{c, none}};
  triangulation.insert(sites.begin(), sites.end());

  const auto refuse = [this](const unsigned int a, const unsigned int b) {
    throw InputError("The " + generators.describe(std::max(a, b)) +
                     " coincides with " + generators.describe(std::min(a, b)) +
                     "; each cell needs a point of its own.");
  };
  site_of_cell.assign(n, nullptr);
  for (const auto vertex : triangulation.finite_vertex_handles())
    site_of_cell[vertex->info().cell] = vertex;
  for (unsigned int c = 0; c < n; ++c)
    if (site_of_cell[c] == nullptr) // it fell onto an earlier point
      refuse(c, triangulation.nearest_vertex(sites[c].first)->info().cell);
  // The nearest neighbour of a point is one of its Delaunay neighbours.
  for (const auto &edge : triangulation.finite_edges())
  {
    const auto a = edge.first->vertex(Delaunay::cw(edge.second));
    const auto b = edge.first->vertex(Delaunay::ccw(edge.second));
    if (CGAL::squared_distance(a->point(), b->point()) <
        resolution * resolution)
      refuse(a->info().cell, b->info().cell);
  }
}

void VoronoiBuilder::insert_mirror_images()
{
  std::vector<SideSet> reaches(generators.points.size());
  if (triangulation.dimension() < 2) // all points on one line
    for (SideSet &sides : reaches)
      sides.set();
  else
    for (const auto face : triangulation.all_face_handles())
    {
      SideSet sides;
      if (triangulation.is_infinite(face))
        sides.set();
      else
      {
        const Point<2> q = circumcentre(face);
        for (unsigned int side = 0; side < n_rectangle_sides; ++side)
          sides[side] = !(beyond(q, side) < -resolution);
      }
      for (unsigned int v = 0; v < 3; ++v)
        if (!triangulation.is_infinite(face->vertex(v)))
          reaches[face->vertex(v)->info().cell] |= sides;
    }

  std::vector<std::pair<Kernel::Point_2, Site>> images;
  for (unsigned int c = 0; c < reaches.size(); ++c)
    for (unsigned int side = 0; side < n_rectangle_sides; ++side)
      if (reaches[c][side])
      {
        Point<2> p = generators.points[c];
        p[side / 2] = 2. * side_coordinate(side) - p[side / 2];
        images.push_back({Kernel::Point_2(p[0], p[1]), Site{c, side}});
      }
  triangulation.insert(images.begin(), images.end());
}

void VoronoiBuilder::make_vertices()
{
  for (const auto face : triangulation.finite_face_handles())
  {
    SideSet sides;
    bool belongs_to_cell = false;
    for (unsigned int v = 0; v < 3; ++v)
    {
      const Site &site = face->vertex(v)->info();
      if (site.mirrored_in == none)
        belongs_to_cell = true;
      else
        sides.set(site.mirrored_in);
    }
    face->info() = none;
    if (!belongs_to_cell)
      continue;

    // A vertex that a cell shares with a mirror image lies on that side:
    // there the coordinate is known exactly.
    Point<2> vertex = circumcentre(face);
    for (unsigned int side = 0; side < n_rectangle_sides; ++side)
      if (sides[side])
        vertex[side / 2] = side_coordinate(side);
    face->info() = vertices.size();
    vertices.push_back(vertex);
    vertex_sides.push_back(sides);
  }
}

/** The Voronoi vertices around a site, counterclockwise. */
template <typename Visitor>
void for_vertices_around(const Delaunay &triangulation,
                         const Delaunay::Vertex_handle site,
                         const Visitor &visit)
{
  Delaunay::Face_circulator face = triangulation.incident_faces(site);
  const Delaunay::Face_circulator begin = face;
  do
    visit(face->info());
  while (++face != begin);
}

void VoronoiBuilder::merge_close_vertices()
{
  const unsigned int n = vertices.size();
  std::vector<unsigned int> rank(n, 0), parent(n);
  boost::disjoint_sets<unsigned int *, unsigned int *> sets(rank.data(),
                                                            parent.data());
  for (unsigned int v = 0; v < n; ++v)
    sets.make_set(v);

  for (const auto site : site_of_cell)
  {
    unsigned int first = none, previous = none;
    const auto merge = [&](const unsigned int a, const unsigned int b) {
      if (vertices[a].distance(vertices[b]) <= resolution)
        sets.union_set(a, b);
    };
    for_vertices_around(triangulation, site, [&](const unsigned int v) {
      if (previous == none)
        first = v;
      else
        merge(previous, v);
      previous = v;
    });
    merge(previous, first);
  }

  // Of the vertices in a set, keep the one that lies on most sides.
  std::vector<unsigned int> kept(n, none);
  for (unsigned int v = 0; v < n; ++v)
  {
    unsigned int &k = kept[sets.find_set(v)];
    if (k == none || vertex_sides[v].count() > vertex_sides[k].count())
      k = v;
  }
  merged_into.resize(n);
  for (unsigned int v = 0; v < n; ++v)
    merged_into[v] = kept[sets.find_set(v)];
}

CellLoops VoronoiBuilder::make_loops()
{
  CellLoops cells;
  cells.centres = generators.points;
  std::vector<unsigned int> number(vertices.size(), none);
  std::vector<unsigned int> loop;
  for (const auto site : site_of_cell)
  {
    loop.clear();
    for_vertices_around(triangulation, site, [&](const unsigned int v) {
      if (loop.empty() || loop.back() != merged_into[v])
        loop.push_back(merged_into[v]);
    });
    while (loop.size() > 1 && loop.back() == loop.front())
      loop.pop_back();
    for (const unsigned int v : loop)
    {
      if (number[v] == none)
      {
        number[v] = cells.vertices.size();
        cells.vertices.push_back(vertices[v]);
      }
      cells.loops.push_back(number[v]);
    }
    cells.first.push_back(cells.loops.size());
  }
  return cells;
}
} // namespace

double Rectangle::area() const
{
  return (upper_right[0] - lower_left[0]) * (upper_right[1] - lower_left[1]);
}

CellLoops voronoi_cells(const PointList &generators, const Rectangle &rectangle)
{
  return VoronoiBuilder(generators, rectangle).build();
}
} // namespace Voussoir
