// SPDX-License-Identifier: LGPL-2.1-or-later

// Cells that penetrate each other: depth and place against closed forms, for
// convex ones and others; none where cells only touch.

#include <voussoir/packing/polyhedra/cell_overlaps.h>

#include "cell_faces.h"
#include "tests.h"
#include <limits>

namespace test_cell_overlaps
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

constexpr double tolerance = 1e-9;

Point<3> turned(const Tensor<2, 3> &R, const Point<3> &p)
{
  return Point<3>(R * Tensor<1, 3>(p));
}

/** A notched block: 3 x 3 without the corner beyond (1, 1), 1 high. */
void add_notched(CellFaces &cells, const double x, const double y)
{
  const Tensor<1, 2> shift({x, y});
  std::vector<Point<2>> ring = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  for (Point<2> &p : ring)
    p += shift;
  add_prism(cells, ring, 0., 1.);
}

void check_boxes()
{
  std::cout << "Boxes that penetrate each other at a face and at a corner"
            << std::endl;
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {1., 1., 1.});
  add_box(cells, {0., 0., 0.99}, {1., 1., 2.});
  add_box(cells, {0.9, 0.8, 1.5}, {2., 2., 2.5});
  add_box(cells, {5., 5., 5.}, {6., 6., 6.});
  const auto found = overlaps(cells, tolerance);
  check("  two pairs",
        found.size() == 2 &&
            found[0].cells == std::array<unsigned int, 2>{{0, 1}} &&
            found[1].cells == std::array<unsigned int, 2>{{1, 2}});
  check_error(
      "  depths",
      std::max(std::abs(found[0].depth - 0.01), std::abs(found[1].depth - 0.1)),
      1e-15);
  check_error("  places",
              std::max(found[0].place.distance({0.5, 0.5, 0.995}),
                       found[1].place.distance({0.95, 0.9, 1.75})),
              1e-15);
  std::cout << "  " << describe_overlaps(cells, found) << std::endl;
  check("  none above the tolerance", overlaps(cells, 0.11).empty());
  check("  one between the two", overlaps(cells, 0.05).size() == 1);
  std::cout << "  " << describe_overlaps(cells, overlaps(cells, 0.05))
            << std::endl;
  check("  none, no sentence",
        describe_overlaps(cells, overlaps(cells, 0.11)).empty());
  cells.n_fixed = 3;
  check("  fixed cells may overlap", overlaps(cells, tolerance).size() == 1);
  check("  no cells", overlaps(CellFaces(), tolerance).empty());
}

void check_crossed_edges()
{
  std::cout << "Two bars with edges that cross" << std::endl;
  // Square bars on their edges, one along x above one along y.
  const double depth = 0.02;
  const auto bars = [](const double depth) {
    CellFaces cells;
    const std::vector<Point<2>> square = {{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
    add_prism(cells, square, -3., 3.);
    add_prism(cells, square, -3., 3.);
    for (unsigned int v = 0; v < cells.vertices.size(); ++v)
    {
      Point<3> &p = cells.vertices[v];
      p = v < 8 ? Point<3>(p[2], p[0], p[1])
                : Point<3>(p[1], p[2], p[0] + 2. - depth);
    }
    return cells;
  };
  const auto found = overlaps(bars(depth), tolerance);
  check("  one pair", found.size() == 1);
  check_error("  depth along the common normal",
              std::abs(found[0].depth - depth), 1e-14);
  check_error("  place", found[0].place.distance({0., 0., 1. - 0.5 * depth}),
              1e-14);
  check("  none if they are apart", overlaps(bars(-1e-6), tolerance).empty());
}

void check_walls_without()
{
  std::cout << "A wall turned and scaled at random" << std::endl;
  Random random(17);
  const CellFaces wall = brick_wall(5, 2, 6);
  unsigned int n_found = 0, n_missed = 0;
  double error = 0.;
  for (unsigned int k = 0; k < 20; ++k)
  {
    const Tensor<2, 3> R = random_rotation(random);
    const double scale = std::pow(10., -3. + 9. * random());
    const auto place = [&](const Point<3> &p) {
      return Point<3>(scale * Tensor<1, 3>(turned(R, p)));
    };
    n_found += overlaps(mapped(wall, place), scale * tolerance).size();
    // One brick is pushed into its neighbour below, and two across the joint.
    CellFaces pushed = wall;
    for (unsigned int v = 8 * 31; v < 8 * 32; ++v)
      pushed.vertices[v][2] -= 1e-4;
    const auto found = overlaps(mapped(pushed, place), scale * tolerance);
    n_missed += found.size() != 2;
    for (const CellOverlap &overlap : found)
      error = std::max(error, std::abs(overlap.depth / scale - 1e-4));
  }
  check("  nothing overlaps", n_found == 0);
  check("  a brick that is pushed into two others does", n_missed == 0);
  check_error("  depth", error, 1e-13);
}

void check_notched()
{
  std::cout << "Notched blocks" << std::endl;
  const auto in_notch = [](const double depth) {
    CellFaces cells;
    add_notched(cells, 0., 0.);
    add_box(cells, {1. - depth, 1., 0.}, {2., 2., 1.});
    return overlaps(cells, tolerance);
  };
  check("  a block in the notch only touches", in_notch(0.).empty());
  check("  too large, it overlaps", in_notch(0.1).size() == 1);
  check_error("  by no more than the depth", in_notch(0.1)[0].depth,
              0.1 * (1. + 1e-12));
  check("  and by a good part of it", in_notch(0.1)[0].depth > 0.04);
  const double x = in_notch(0.1)[0].place[0];
  check("  at a place in both", x > 0.9 - 1e-12 && x < 1. + 1e-12);

  const auto pair = [](const double x, const double y) {
    CellFaces cells;
    add_notched(cells, 0., 0.);
    add_notched(cells, x, y);
    return overlaps(cells, tolerance);
  };
  check("  two, one in the notch of the other", pair(1., 1.).empty());
  check("  shifted", pair(0.5, 0.).size() == 1);
  check("  twice the same", pair(0., 0.).size() == 1);

  CellFaces crossed;
  add_notched(crossed, 0., 0.);
  add_box(crossed, {0.4, 2., -1.}, {0.6, 2.2, 2.});
  add_box(crossed, {0.2, -5., 0.2}, {0.3, 5., 0.3});
  check("  a bar across it, and one along it",
        overlaps(crossed, tolerance).size() == 2);
  CellFaces inside;
  add_notched(inside, 0., 0.);
  add_box(inside, {0.4, 2., 0.4}, {0.6, 2.2, 0.6});
  const auto found = overlaps(inside, tolerance);
  check("  a block inside", found.size() == 1);
  check_error("  its centre is the deepest point",
              std::abs(found[0].depth - 0.5), 1e-6);

  Random random(19);
  unsigned int n_wrong = 0;
  for (unsigned int k = 0; k < 20; ++k)
  {
    const Tensor<2, 3> R = random_rotation(random);
    CellFaces cells;
    add_notched(cells, 0., 0.);
    add_notched(cells, 1., 1.);
    add_notched(cells, 2., 2.);
    cells = mapped(cells, [&](const Point<3> &p) { return turned(R, p); });
    n_wrong += !overlaps(cells, tolerance).empty();
  }
  check("  turned, they only touch", n_wrong == 0);
}

void run()
{
  check_boxes();
  check_crossed_edges();
  check_walls_without();
  check_notched();
  show_refusal([] { overlaps(CellFaces(), -0.5); });
  show_refusal(
      [] { overlaps(CellFaces(), std::numeric_limits<double>::infinity()); });
}

const RoomTest test("cell_overlaps", run);
} // namespace test_cell_overlaps
