// SPDX-License-Identifier: LGPL-2.1-or-later

// Voronoi cells: they fill the rectangle, their interfaces bisect the line
// between the generators, and degenerate positions give the right neighbours.

#include "tests.h"

namespace test_voronoi_properties
{
using namespace Voussoir;

/** The defining properties, whatever the points. */
void check_voronoi(const std::string &name,
                   const PointList<2> &points,
                   const Rectangle &rectangle)
{
  const Packing<2> packing(voronoi_cells(points, rectangle));
  const double size = std::sqrt(rectangle.area());
  std::cout << name << ": " << packing.n_cells() << " cells" << std::endl;
  check_error("  area", std::abs(packing.area() / rectangle.area() - 1.),
              1e-12);

  double bisector = 0., normal = 0., closure = 0., nearest = 0.;
  for (const auto &i : packing.interfaces())
  {
    const auto &minus = packing.centre(i.cell_minus);
    const auto &plus = packing.centre(i.cell_plus);
    for (const auto &end : {i.start, i.end})
      bisector = std::max(
          bisector, std::abs(end.distance(minus) - end.distance(plus)) / size);
    // Short edges have a direction only up to the rounding of their ends.
    normal = std::max(normal, std::abs((plus - minus) * i.tangent()) /
                                  (plus - minus).norm() * i.length / size);
    for (unsigned int c = 0; c < std::min(packing.n_cells(), 200U); ++c)
      nearest = std::max(nearest, (i.midpoint().distance(minus) -
                                   i.midpoint().distance(packing.centre(c))) /
                                      size);
  }
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    dealii::Tensor<1, 2> sum;
    for (const auto &side : packing.sides(c))
      if (side.on_boundary)
        sum += packing.boundary_edges()[side.index].length *
               packing.boundary_edges()[side.index].normal;
      else
      {
        const auto &i = packing.interfaces()[side.index];
        sum += (i.cell_minus == c ? 1. : -1.) * i.length * i.normal;
      }
    closure = std::max(closure, sum.norm() / size);
  }
  check_error("  ends equidistant from both centres", bisector, 1e-12);
  check_error("  no centre nearer to an interface", nearest, 1e-12);
  check_error("  tangent across the centre line", normal, 1e-12);
  check_error("  closed cells", closure, 1e-14);

  double off_side = 0.;
  for (const auto &edge : packing.boundary_edges())
  {
    double distance = 1e300;
    for (unsigned int d = 0; d < 2; ++d)
      for (const auto &corner : {rectangle.lower_left, rectangle.upper_right})
        distance = std::min(distance, std::abs(edge.start[d] - corner[d]) +
                                          std::abs(edge.end[d] - corner[d]));
    off_side = std::max(off_side, distance);
  }
  check_error("  boundary edges on the sides", off_side, 0.);
}

PointList<2> points(const std::vector<dealii::Point<2>> &list)
{
  PointList<2> result;
  result.points = list;
  return result;
}

void run()
{
  const Rectangle unit = {{0, 0}, {1, 1}};
  const Rectangle long_one = {{-30, 5}, {10, 5.5}};
  check_voronoi("random", random_points(1000, 1), unit);
  check_voronoi("random in a long rectangle", random_points(500, 2, long_one),
                long_one);
  check_voronoi("one point", points({{0.3, 0.8}}), unit);
  check_voronoi("two points", points({{0.1, 0.2}, {0.9, 0.7}}), unit);
  check_voronoi("points on a line",
                points({{0.1, 0.5}, {0.4, 0.5}, {0.6, 0.5}, {0.95, 0.5}}),
                unit);
  check_voronoi("points on a slanted line",
                points({{0.25, 0.25}, {0.5, 0.5}, {0.125, 0.125}}), unit);

  // Points that leave very slender triangles: on a line, and in a small part of
  // the rectangle.
  for (unsigned int seed = 1; seed <= 20; ++seed)
    for (const Rectangle &part : {Rectangle{{0., 0.3}, {1., 0.3}},
                                  Rectangle{{0.4, 0.4}, {0.401, 0.401}},
                                  Rectangle{{0.9, 0.1}, {0.91, 0.11}}})
      Packing<2> packing(voronoi_cells(random_points(40, seed, part), unit));
  std::cout << "slender triangles: OK" << std::endl;

  // A square grid: every inner vertex is on the circle of four points.
  PointList<2> grid;
  const unsigned int n = 16;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      grid.points.emplace_back((i + 0.5) / n, (j + 0.5) / n);
  check_voronoi("grid", grid, unit);
  check("  four neighbours at most",
        Packing<2>(voronoi_cells(grid, unit)).interfaces().size() ==
            2 * n * (n - 1));

  // The same with coordinates that are not binary fractions.
  PointList<2> thirds;
  for (unsigned int i = 0; i < 9; ++i)
    for (unsigned int j = 0; j < 9; ++j)
      thirds.points.emplace_back((i + 0.5) / 9 * 0.7, (j + 0.5) / 9 * 0.1);
  const Rectangle odd = {{0, 0}, {0.7, 0.1}};
  check_voronoi("grid with rounding", thirds, odd);
  check("  four neighbours at most",
        Packing<2>(voronoi_cells(thirds, odd)).interfaces().size() ==
            2 * 9 * 8);

  // Twelve points on a circle around a thirteenth, far from the sides.
  PointList<2> ring = points({{0.5, 0.5}});
  for (unsigned int i = 0; i < 12; ++i)
    ring.points.emplace_back(0.5 + 0.3 * std::cos(i * dealii::numbers::PI / 6),
                             0.5 + 0.3 * std::sin(i * dealii::numbers::PI / 6));
  check_voronoi("ring", ring, unit);
  check("  the centre has twelve sides",
        Packing<2>(voronoi_cells(ring, unit)).n_sides(0) == 12);
}

const RoomTest test("voronoi_properties", run);
} // namespace test_voronoi_properties
