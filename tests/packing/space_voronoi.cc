// SPDX-License-Identifier: LGPL-2.1-or-later

// Voronoi cells in space: of few points, of random points from fifty seeds, at
// any scale and place, and of points in a small part of the domain.

#include "space_voronoi_checks.h"

namespace test_space_voronoi
{
using namespace space_voronoi_checks;

void check_few_points()
{
  check_cells("one point", {{0.3, 0.8, 0.1}}, unit);
  const CellFaces two =
      check_cells("two points", {{0.25, 0.5, 0.5}, {0.5, 0.5, 0.5}}, unit);
  check_error("  three eighths", std::abs(moments_of(two, 0).volume - 0.375),
              1e-15);
  check("  faces", two.n_faces() == 12 && two.vertices.size() == 12);
  check_cells("three points",
              {{0.1, 0.2, 0.3}, {0.9, 0.7, 0.2}, {0.4, 0.5, 0.8}}, unit);
  check_cells("four points",
              {{0.1, 0.2, 0.3}, {0.9, 0.7, 0.2}, {0.4, 0.5, 0.8}, {.6, .1, .7}},
              unit);
  check_cells(
      "points in a line",
      {{0.1, 0.5, 0.5}, {0.4, 0.5, 0.5}, {0.6, 0.5, 0.5}, {0.95, 0.5, 0.5}},
      unit);
  check_cells("points in a slanted line",
              {{0.25, 0.25, 0.25},
               {0.5, 0.5, 0.5},
               {0.125, 0.125, 0.125},
               {0.7, 0.7, 0.7}},
              unit);
}

void check_many_seeds()
{
  Errors worst;
  for (unsigned int seed = 1; seed <= 50; ++seed)
  {
    const Errors of = errors_of(
        voronoi_cells(listed(random_in_box(20 + seed, seed)), unit), unit);
    largest(worst.volume, of.volume);
    largest(worst.bisector, of.bisector);
    largest(worst.nearest, of.nearest);
    largest(worst.plane, of.plane);
    largest(worst.areas, of.areas);
    worst.width = std::min(worst.width, of.width);
    worst.are_closed &= of.are_closed;
    worst.are_simple &= of.are_simple;
    worst.are_shared &= of.are_shared;
    worst.have_corners &= of.have_corners;
    worst.have_one_face &= of.have_one_face;
    worst.are_wide &= of.are_wide;
  }
  std::cout << "fifty seeds" << std::endl;
  check_errors(worst, {});
}

void check_extremes()
{
  check_cells("a slab",
              random_in_box(100, 2, {{-30., 5., 0.}, {10., 5.5, 20.}}),
              ConvexPolyhedron(Box{{-30., 5., 0.}, {10., 5.5, 20.}}));
  // Points that leave very flat tetrahedra.
  for (const Box &part : {Box{{0.01, 0.3, 0.01}, {0.99, 0.3, 0.99}},
                          Box{{0.4, 0.4, 0.4}, {0.401, 0.401, 0.401}},
                          Box{{0.9, 0.1, 0.5}, {0.91, 0.9, 0.501}}})
    check_cells("points in a part of the cube", random_in_box(60, 4, part),
                unit);

  const auto points = random_in_box(80, 9);
  const CellFaces cells = voronoi_cells(listed(points), unit);
  for (const double scale : {1e-6, 1e6, 1e-40, 1e40})
  {
    std::vector<Point<3>> scaled;
    for (const Point<3> &p : points)
      scaled.push_back(scale * p);
    const CellFaces large =
        check_cells("scaled by " + text(scale), scaled,
                    ConvexPolyhedron(Box{{0., 0., 0.}, {scale, scale, scale}}));
    double error = 0.;
    for (unsigned int c = 0; c < cells.n_cells(); ++c)
      largest(error, moments_of(large, c).volume / scale / scale / scale /
                             moments_of(cells, c).volume -
                         1.);
    check_error("  volumes of cells", error, 1e-12);
    check("  the same faces", large.loops == cells.loops);
  }
  const double away = 1e4;
  std::vector<Point<3>> moved;
  for (const Point<3> &p : points)
    moved.emplace_back(p[0] + away, p[1] - away, p[2] + away);
  const CellFaces there =
      check_cells("moved by ten thousand sizes", moved,
                  ConvexPolyhedron(Box{{away, -away, away},
                                       {away + 1, -away + 1, away + 1}}),
                  {1e-11, 1e-11, 1e-10, 0.});
  double error = 0.;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    largest(error,
            moments_of(there, c).volume / moments_of(cells, c).volume - 1.);
  check_error("  volumes of cells", error, 1e-8);
  check("  the same faces", there.loops == cells.loops);
}

void run()
{
  check_few_points();
  check_many_seeds();
  check_extremes();
}

const RoomTest test("space_voronoi", run);
} // namespace test_space_voronoi
