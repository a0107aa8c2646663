// SPDX-License-Identifier: LGPL-2.1-or-later

// Voronoi cells in convex polyhedra: with corners of three and more planes, and
// faces of three and more corners, which are plane to rounding.

#include "space_voronoi_checks.h"

namespace test_space_voronoi_polyhedra
{
using namespace space_voronoi_checks;

/** Points all over a polyhedron. */
std::vector<Point<3>> random_inside(const ConvexPolyhedron &domain,
                                    const unsigned int n)
{
  return random_points(n, 1, domain, CellSize<3>("1", "size")).points;
}

void check_polyhedra()
{
  const ErrorBounds slanted = {1e-12, 4e-15, 2e-12, 4e-15};
  const ConvexPolyhedron tetrahedron(
      std::vector<Point<3>>{{0, 0, 0}, {1, 0, 0}, {0.2, 1, 0}, {0.3, 0.3, 1}});
  check_error("tetrahedron", std::abs(tetrahedron.volume() - 1. / 6.), 1e-16);
  check_cells("one point in a tetrahedron", {{0.3, 0.3, 0.3}}, tetrahedron,
              slanted);
  check_cells("in a tetrahedron", random_inside(tetrahedron, 60), tetrahedron,
              slanted);

  // Corners of four planes, with a point in the middle of the ways.
  const ConvexPolyhedron octahedron(std::vector<Point<3>>{{1, 0, 0},
                                                          {-1, 0, 0},
                                                          {0, 1, 0},
                                                          {0, -1, 0},
                                                          {0, 0, 1},
                                                          {0, 0, -1},
                                                          {0.1, 0.2, 0.1}});
  check_error("octahedron", std::abs(octahedron.volume() - 4. / 3.), 1e-15);
  check("  faces and corners",
        octahedron.n_planes() == 8 && octahedron.faces().vertices.size() == 6);
  check_cells("in its middle", {{0, 0, 0}}, octahedron, slanted);
  check_cells("on its axes",
              {{0, 0, 0.5},
               {0, 0, -0.5},
               {0.5, 0, 0},
               {-0.5, 0, 0},
               {0, 0.5, 0},
               {0, -0.5, 0}},
              octahedron, slanted);
  check_cells("in an octahedron", random_inside(octahedron, 100), octahedron,
              slanted);

  // A turned prism of seven sides, whose sides are plane to rounding only.
  std::vector<Point<3>> prism;
  for (unsigned int i = 0; i < 14; ++i)
  {
    const double angle = 2. * dealii::numbers::PI * (i / 2) / 7;
    const double x = std::cos(angle), y = std::sin(angle), z = i % 2;
    prism.emplace_back(0.6 * x - 0.8 * z, y, 0.8 * x + 0.6 * z);
  }
  const ConvexPolyhedron heptagonal(prism);
  check("prism of seven sides",
        heptagonal.n_planes() == 9 && heptagonal.faces().vertices.size() == 14);
  check_cells("in a prism", random_inside(heptagonal, 100), heptagonal,
              slanted);
  std::vector<Point<3>> ball;
  Random random(11);
  for (unsigned int i = 0; i < 40; ++i)
  {
    Tensor<1, 3> arm({random.normal(), random.normal(), random.normal()});
    ball.push_back(Point<3>(arm / arm.norm()));
  }
  const ConvexPolyhedron round(ball);
  check("hull of points on a sphere",
        round.n_planes() == 76 && round.faces().vertices.size() == 40);
  check_cells("in the hull", random_inside(round, 100), round, slanted);
  check_cells("one point in the hull", {{0., 0., 0.}}, round, slanted);
}

void run()
{
  check_polyhedra();
}

const RoomTest test("space_voronoi_polyhedra", run);
} // namespace test_space_voronoi_polyhedra
