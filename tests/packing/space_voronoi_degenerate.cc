// SPDX-License-Identifier: LGPL-2.1-or-later

// Voronoi cells of points of which many lie on one sphere: lattices, jittered
// by more or less than is resolved, which have the faces and volumes of closed
// forms, and the corners of an icosahedron.

#include "space_voronoi_checks.h"
#include <map>

namespace test_space_voronoi_degenerate
{
using namespace space_voronoi_checks;

/** The number of cells with each number of faces, of those away from sides. */
std::map<unsigned int, unsigned int> inner_cells(const CellFaces &cells)
{
  std::vector<bool> is_inside(cells.n_faces(), false);
  for (const auto &pair : cells.shared)
    is_inside[pair[0]] = is_inside[pair[1]] = true;
  std::map<unsigned int, unsigned int> count;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    const unsigned int begin = cells.first_face[c],
                       end = cells.first_face[c + 1];
    if (std::all_of(is_inside.begin() + begin, is_inside.begin() + end,
                    [](const bool inside) { return inside; }))
      ++count[end - begin];
  }
  return count;
}

/** n^3 points of a lattice, with another in the middle of each cube if so. */
std::vector<Point<3>> lattice(const unsigned int n,
                              const double jitter,
                              const bool is_centred = false)
{
  Random random(7);
  std::vector<Point<3>> points;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int k = 0; k < n; ++k)
        for (const double shift : {0.25, 0.75})
        {
          if (shift > 0.5 && !is_centred)
            continue;
          Point<3> p(i + shift, j + shift, k + shift);
          for (unsigned int d = 0; d < 3; ++d)
            p[d] = (p[d] + (is_centred ? 0. : 0.25)) / n +
                   jitter * (2. * random() - 1.);
          points.push_back(p);
        }
  return points;
}

void check_lattices()
{
  const unsigned int n = 5;
  const unsigned int n_shared = 3 * n * n * (n - 1);
  const std::map<unsigned int, unsigned int> cubes = {{6, 27}};
  const ErrorBounds joined = {1e-12, 1e-12, 2e-12, 0.};
  for (const double jitter : {0., 1e-15, 1e-14})
  {
    const CellFaces grid = check_cells("grid jittered by " + text(jitter),
                                       lattice(n, jitter), unit, joined);
    check("  cubes", grid.shared.size() == n_shared &&
                         grid.vertices.size() == (n + 1) * (n + 1) * (n + 1) &&
                         inner_cells(grid) == cubes);
  }
  for (const double jitter : {1e-13, 1e-12, 1e-11, 1e-9, 1e-6})
    check("  cubes with their edges cut off",
          check_cells("grid jittered by " + text(jitter), lattice(n, jitter),
                      unit, joined)
                  .shared.size() >= n_shared);
  check_cells(
      "grid in one plane",
      [] {
        std::vector<Point<3>> points;
        for (unsigned int i = 0; i < 36; ++i)
          points.emplace_back((i % 6 + 0.5) / 6, (i / 6 + 0.5) / 6, 0.3);
        return points;
      }(),
      unit);
  for (const double jitter : {1e-13, 1e-9})
    check_cells(
        "grid in one plane jittered by " + text(jitter),
        [&] {
          Random random(3);
          std::vector<Point<3>> points;
          for (unsigned int i = 0; i < 36; ++i)
            points.emplace_back((i % 6 + 0.5) / 6 + jitter * random(),
                                (i / 6 + 0.5) / 6 + jitter * random(),
                                0.3 + jitter * random());
          return points;
        }(),
        unit, joined);

  // Truncated octahedra where all neighbours are, and rhombic dodecahedra with
  // corners of four faces.
  const CellFaces centred =
      check_cells("body-centred lattice", lattice(4, 0., true), unit);
  check("  truncated octahedra", inner_cells(centred)[14] == 16);
  std::vector<Point<3>> faces;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 6; ++k)
        if ((i + j + k) % 2 == 0)
          faces.emplace_back((i + 0.5) / 6, (j + 0.5) / 6, (k + 0.5) / 6);
  const std::map<unsigned int, unsigned int> dodecahedra = {{12, 32}};
  check("  rhombic dodecahedra",
        inner_cells(check_cells("face-centred lattice", faces, unit)) ==
            dodecahedra);
}

void check_cospherical()
{
  // The corners of an icosahedron around its middle: a dodecahedron.
  const double golden = (1. + std::sqrt(5.)) / 2.;
  std::vector<Point<3>> points = {{0.5, 0.5, 0.5}};
  for (const double a : {-1., 1.})
    for (const double b : {-golden, golden})
      for (unsigned int d = 0; d < 3; ++d)
      {
        Tensor<1, 3> arm;
        arm[d] = a;
        arm[(d + 1) % 3] = b;
        points.push_back(points[0] + 0.1 * arm);
      }
  const CellFaces cells = check_cells("icosahedron", points, unit);
  std::set<unsigned int> corners;
  bool are_pentagons = cells.first_face[1] == 12;
  for (unsigned int f = 0; f < cells.first_face[1]; ++f)
  {
    are_pentagons &= cells.n_corners(f) == 5;
    for (const unsigned int v : cells.corners(f))
      corners.insert(v);
  }
  check("  dodecahedron in the middle", are_pentagons && corners.size() == 20);
  // By its inner radius, half of the distance of the corners from the middle.
  const double radius = 0.05 * std::sqrt(1. + golden * golden);
  const double volume =
      10. * std::sqrt(130. - 58. * std::sqrt(5.)) * std::pow(radius, 3);
  check_error("  its volume", std::abs(moments_of(cells, 0).volume - volume),
              1e-16);
  Random random(5);
  std::vector<Point<3>> sphere;
  for (unsigned int i = 0; i < 60; ++i)
  {
    Tensor<1, 3> arm({random.normal(), random.normal(), random.normal()});
    sphere.push_back(Point<3>(0.5, 0.5, 0.5) + 0.3 / arm.norm() * arm);
  }
  check_cells("random points on a sphere", sphere, unit);
}

void run()
{
  check_lattices();
  check_cospherical();
}

const RoomTest test("space_voronoi_degenerate", run);
} // namespace test_space_voronoi_degenerate
