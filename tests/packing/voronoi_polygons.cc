// SPDX-License-Identifier: LGPL-2.1-or-later

// Voronoi cells of convex polygons: they fill the polygon to rounding, each is
// what lies nearest to its generator, and vertices on a side are on it,
// whatever the polygon and wherever the generators.

#include <voussoir/base/geometry.h>
#include <voussoir/base/random.h>

#include "tests.h"

namespace test_voronoi_polygons
{
using namespace Voussoir;
using dealii::Point;

/** How far @p p lies beyond the sides of a cell at most; negative inside. */
double
beyond(const Packing<2> &packing, const unsigned int c, const Point<2> &p)
{
  double largest = -1e300;
  for (unsigned int i = 0; i < packing.n_sides(c); ++i)
  {
    const Point<2> &a = packing.vertex(c, i), &b = packing.vertex(c, i + 1);
    largest = std::max(largest, cross(p - a, b - a) / a.distance(b));
  }
  return largest;
}

/** The largest distance between points of the polygon. */
double diameter(const ConvexPolygon &polygon)
{
  double largest = 0.;
  for (unsigned int i = 0; i < polygon.n_sides(); ++i)
    for (unsigned int j = 0; j < i; ++j)
      largest =
          std::max(largest, polygon.vertex(i).distance(polygon.vertex(j)));
  return largest;
}

/** Points that are nearest to a generator lie in its cell. */
double probe(const Packing<2> &packing, const ConvexPolygon &polygon)
{
  const PointList<2> probes =
      random_points(300, 99, polygon, CellSize<2>("1", "size"));
  double error = 0.;
  for (const Point<2> &p : probes.points)
  {
    unsigned int nearest = 0;
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      if (p.distance(packing.centre(c)) < p.distance(packing.centre(nearest)))
        nearest = c;
    error = std::max(error, beyond(packing, nearest, p));
  }
  return error / diameter(polygon);
}

struct Errors
{
  double area = 0., perimeter = 0., side = 0., corner = 0., bisector = 0.,
         nearest = 0.;
};

Errors errors_of(const std::vector<Point<2>> &points,
                 const ConvexPolygon &polygon)
{
  PointList<2> list;
  list.points = points;
  const Packing<2> packing(voronoi_cells(list, polygon));
  const double size = diameter(polygon);
  Errors errors;
  errors.area = std::abs(packing.area() / polygon.area() - 1.);

  double length = 0., perimeter = 0.;
  for (unsigned int i = 0; i < polygon.n_sides(); ++i)
  {
    perimeter += polygon.vertex(i).distance(polygon.vertex(i + 1));
    double nearest = 1e300;
    for (const auto &edge : packing.boundary_edges())
      nearest = std::min(nearest, edge.start.distance(polygon.vertex(i)));
    errors.corner = std::max(errors.corner, nearest);
  }
  for (const auto &edge : packing.boundary_edges())
  {
    length += edge.length;
    double nearest = 1e300;
    for (unsigned int i = 0; i < polygon.n_sides(); ++i)
      nearest = std::min(nearest, std::abs(polygon.beyond(edge.start, i)) +
                                      std::abs(polygon.beyond(edge.end, i)));
    errors.side = std::max(errors.side, nearest / size);
  }
  errors.perimeter = std::abs(length / perimeter - 1.);
  for (const auto &i : packing.interfaces())
    for (const auto &end : {i.start, i.end})
      errors.bisector = std::max(
          errors.bisector, std::abs(end.distance(packing.centre(i.cell_minus)) -
                                    end.distance(packing.centre(i.cell_plus))) /
                               size);
  errors.nearest = probe(packing, polygon);
  return errors;
}

/** The worst of many sets of points, and what it must not exceed. */
void check_all(const std::string &name,
               const ConvexPolygon &polygon,
               const std::vector<std::vector<Point<2>>> &sets)
{
  Errors worst;
  for (const auto &points : sets)
  {
    const Errors e = errors_of(points, polygon);
    worst.area = std::max(worst.area, e.area);
    worst.perimeter = std::max(worst.perimeter, e.perimeter);
    worst.side = std::max(worst.side, e.side);
    worst.corner = std::max(worst.corner, e.corner);
    worst.bisector = std::max(worst.bisector, e.bisector);
    worst.nearest = std::max(worst.nearest, e.nearest);
  }
  std::cout << name << std::endl;
  check_error("  area", worst.area, 1e-13);
  check_error("  length of the boundary", worst.perimeter, 1e-13);
  check_error("  vertices on the sides", worst.side, 1e-15);
  check_error("  corners of the polygon", worst.corner, 0.);
  check_error("  ends equidistant from both centres", worst.bisector, 1e-13);
  check_error("  nearest to the own generator", worst.nearest, 1e-13);
}

ConvexPolygon regular(const unsigned int n)
{
  std::vector<Point<2>> vertices;
  for (unsigned int i = 0; i < n; ++i)
    vertices.emplace_back(std::cos(2 * dealii::numbers::PI * (i + 0.3) / n),
                          std::sin(2 * dealii::numbers::PI * (i + 0.3) / n));
  return ConvexPolygon(vertices);
}

/** A number of sets of points at random, in few and in many. */
std::vector<std::vector<Point<2>>> random_sets(const ConvexPolygon &polygon)
{
  const CellSize<2> size("1", "size");
  std::vector<std::vector<Point<2>>> sets;
  for (unsigned int seed = 1; seed <= 20; ++seed)
    for (const unsigned int n : {1, 2, 3, 4, 7, 20, 100})
      sets.push_back(random_points(n, seed, polygon, size).points);
  sets.push_back(random_points(3000, 1, polygon, size).points);
  return sets;
}

/** Points at the distances 1e-2 to 1e-11 from all sides and corners. */
std::vector<std::vector<Point<2>>> sets_near_sides(const ConvexPolygon &polygon)
{
  Point<2> middle;
  for (unsigned int i = 0; i < polygon.n_sides(); ++i)
    middle += polygon.vertex(i) / polygon.n_sides();
  std::vector<std::vector<Point<2>>> sets;
  Random random(1);
  for (unsigned int k = 2; k <= 11; ++k)
  {
    const double distance = std::pow(10., -1. * k);
    std::vector<Point<2>> near_sides, near_corners;
    for (unsigned int i = 0; i < polygon.n_sides(); ++i)
    {
      const Point<2> &a = polygon.vertex(i), &b = polygon.vertex(i + 1);
      near_corners.push_back(a + distance * (middle - a));
      for (unsigned int m = 0; m < 4; ++m)
      {
        const Point<2> on_side = a + (m + 0.1 + 0.8 * random()) / 4. * (b - a);
        near_sides.push_back(on_side + distance * (middle - on_side));
      }
    }
    sets.push_back(near_sides);
    sets.push_back(near_corners);
    near_sides.push_back(middle);
    sets.push_back(near_sides);
  }
  return sets;
}

/** Collinear, cocircular and grid points, symmetric to the sides or not. */
std::vector<std::vector<Point<2>>> special_sets(const ConvexPolygon &polygon)
{
  Point<2> middle;
  for (unsigned int i = 0; i < polygon.n_sides(); ++i)
    middle += polygon.vertex(i) / polygon.n_sides();
  double radius = 1e300;
  for (unsigned int i = 0; i < polygon.n_sides(); ++i)
    radius = std::min(radius, -0.99 * polygon.beyond(middle, i));

  std::vector<std::vector<Point<2>>> sets;
  std::vector<Point<2>> line, to_corner, ring, turned, grid, shrunk;
  for (int i = -4; i <= 4; ++i)
  {
    line.emplace_back(middle[0] + radius * i / 4.5, middle[1]);
    to_corner.push_back(middle + (i + 5) / 10. * (polygon.vertex(0) - middle));
    for (int j = -4; j <= 4; ++j)
      grid.emplace_back(middle[0] + radius * i / 6.,
                        middle[1] + radius * j / 6.);
  }
  for (unsigned int i = 0; i < 16; ++i)
    ring.emplace_back(
        middle[0] + radius * std::cos(dealii::numbers::PI / 8 * i),
        middle[1] + radius * std::sin(dealii::numbers::PI / 8 * i));
  for (unsigned int i = 0; i < polygon.n_sides(); ++i)
  {
    shrunk.push_back(middle + 0.9 * (polygon.vertex(i) - middle));
    turned.push_back(middle + 0.4 * (polygon.vertex(i) - middle) +
                     0.4 * (polygon.vertex(i + 1) - middle));
  }
  for (const auto &set : {line, to_corner, ring, turned, grid, shrunk})
    sets.push_back(set);

  // Three points at the same distance from a corner: it is a vertex of all.
  const Point<2> &corner = polygon.vertex(0);
  const auto after = polygon.vertex(1) - corner;
  const auto before = polygon.vertex(polygon.n_sides() - 1) - corner;
  const double distance = 0.5 * cross(after, before) / (after - before).norm();
  std::vector<Point<2>> around;
  for (const double part : {0.2, 0.5, 0.8})
  {
    const auto direction = (1. - part) * after + part * before;
    around.push_back(corner + distance / direction.norm() * direction);
  }
  sets.push_back(around);
  return sets;
}

void check_polygon(const std::string &name, const ConvexPolygon &polygon)
{
  check_all(name + ", random points", polygon, random_sets(polygon));
  check_all(name + ", points near the boundary", polygon,
            sets_near_sides(polygon));
  check_all(name + ", points in special positions", polygon,
            special_sets(polygon));
}

void refuse(const std::vector<Point<2>> &vertices)
{
  show_refusal([&] { ConvexPolygon polygon(vertices); });
}

void run()
{
  check_polygon("hexagon", regular(6));
  check_polygon("octagon", regular(8));
  check_polygon("100 sides", regular(100));
  check_polygon("triangle",
                ConvexPolygon({{0.1, 0.2}, {1.3, 0.4}, {0.3, 0.9}}));
  check_polygon("acute triangle",
                ConvexPolygon({{0., 0.}, {1., 0.02}, {0.95, 0.06}}));
  check_polygon("clockwise trapezoid",
                ConvexPolygon({{-3., 7.}, {2., 8.}, {4., 6.}, {-5., 3.}}));
  check_polygon(
      "a corner cut off",
      ConvexPolygon(
          {{0., 0.}, {1. - 1e-6, 0.}, {1., 1e-6}, {1., 1.}, {0., 1.}}));

  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuse({{0, 0}, {1, 0}});
  refuse({{0, 0}, {1e-80, 0}, {0, 1e-80}});
  refuse({{1e80, 0}, {1e80 + 1e70, 0}, {1e80, 1e70}});
  refuse({{0, 0}, {1, 0}, {nan, 1}});
  refuse({{0, 0}, {1, 0}, {2, 0}});
  refuse({{0, 0}, {1, 0}, {1, 0}, {0, 1}});
  refuse({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}});
  refuse({{0, 0}, {0.5, 0}, {1, 0}, {0, 1}});
  refuse({{0, 0}, {1, 1e-12}, {2, 0}, {0, 1}});
  refuse({{0, 0}, {2, 0}, {1, 0.5}, {2, 2}, {0, 2}});
  refuse({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  std::vector<Point<2>> star;
  for (unsigned int i = 0; i < 5; ++i)
    star.emplace_back(std::cos(0.8 * dealii::numbers::PI * i),
                      std::sin(0.8 * dealii::numbers::PI * i));
  refuse(star);
  PointList<2> list;
  list.points = {{0., 0.}, {0.9, 0.9}};
  show_refusal([&] { voronoi_cells(list, regular(6)); });
}

const RoomTest test("voronoi_polygons", run);
} // namespace test_voronoi_polygons
