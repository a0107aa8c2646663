// SPDX-License-Identifier: LGPL-2.1-or-later

// Voronoi cells in space, whatever the points: cells are closed and fill the
// domain, faces bisect the line between two centres, and no centre is nearer to
// a vertex than that of its cell. As the part of the domain that is nearest to
// a centre is convex, these are all that a Voronoi cell is. Lattices, points on
// a sphere and few points have the faces and volumes of closed forms.

#include <voussoir/base/random.h>
#include <voussoir/packing/polyhedra/cell_moments.h>
#include <voussoir/packing/polyhedra/space_polygons.h>
#include <voussoir/packing/polyhedra/voronoi/random_points.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi_cells.h>

#include "tests.h"
#include <map>
#include <set>

namespace test_space_voronoi
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

/** Errors of cells, lengths over the size of the domain. */
struct Errors
{
  /** Of the narrowest face, over the mean size of a cell. */
  double width = 1.;
  double volume = 0., bisector = 0., nearest = 0., plane = 0., areas = 0.;
  bool are_closed = true, are_simple = true, are_shared = true,
       have_corners = true, have_one_face = true, are_wide = true;
};

void largest(double &value, const double other)
{
  value = std::max(value, std::abs(other));
}

/** The largest distance of a corner from the longest diagonal. */
double width_of(const std::vector<Point<3>> &polygon)
{
  Point<3> origin;
  Tensor<1, 3> chord;
  for (const Point<3> &a : polygon)
    for (const Point<3> &b : polygon)
      if (a.distance(b) > chord.norm())
      {
        origin = a;
        chord = b - a;
      }
  double width = 0.;
  for (const Point<3> &p : polygon)
    largest(width, cross_product_3d(p - origin, chord / chord.norm()).norm());
  return width;
}

/** Faces of two cells: in pairs of opposite loops in the bisector plane. */
void judge_shared_faces(const CellFaces &cells, const double size, Errors &of)
{
  std::set<std::array<unsigned int, 2>> pairs;
  std::vector<bool> is_shared(cells.n_faces(), false);
  for (const auto &[f, g] : cells.shared)
  {
    of.are_shared &= f < g && !is_shared[f] && !is_shared[g];
    is_shared[f] = is_shared[g] = true;
    const auto there = cells.corners(f), back = cells.corners(g);
    std::vector<unsigned int> a(there.begin(), there.end());
    std::vector<unsigned int> b(back.begin(), back.end());
    std::reverse(b.begin(), b.end());
    std::rotate(a.begin(), std::min_element(a.begin(), a.end()), a.end());
    std::rotate(b.begin(), std::min_element(b.begin(), b.end()), b.end());
    of.are_shared &= a == b;
    const unsigned int c = cells.cell_of_face(f), d = cells.cell_of_face(g);
    of.have_one_face &= pairs.insert({c, d}).second;
    const Point<3> &p = cells.centres[c], &q = cells.centres[d];
    const Tensor<1, 3> normal = (q - p) / q.distance(p);
    for (const unsigned int v : a)
      largest(of.bisector,
              ((cells.vertices[v] - p) * normal - 0.5 * q.distance(p)) / size);
    const auto polygon = cells.polygon(f);
    of.are_wide &=
        moments_of(dealii::make_array_view(polygon)).vector_area * normal > 0.;
  }
}

/** Other faces: one a cell and plane, together the face of the domain. */
void judge_boundary(const CellFaces &cells,
                    const ConvexPolyhedron &domain,
                    Errors &of)
{
  std::vector<bool> is_shared(cells.n_faces(), false);
  for (const auto &pair : cells.shared)
    is_shared[pair[0]] = is_shared[pair[1]] = true;
  std::vector<double> area(domain.n_planes(), 0.);
  std::set<std::array<unsigned int, 2>> faces;
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
  {
    if (is_shared[f])
      continue;
    const auto polygon = cells.polygon(f);
    const auto moments = moments_of(dealii::make_array_view(polygon));
    double least = 1e300;
    unsigned int plane = 0;
    for (unsigned int k = 0; k < domain.n_planes(); ++k)
    {
      double distance = 0.;
      for (const Point<3> &vertex : polygon)
        largest(distance, domain.beyond(vertex, k));
      if (distance < least)
      {
        least = distance;
        plane = k;
      }
    }
    largest(of.plane, least / domain.extent());
    of.are_wide &= moments.vector_area * domain.plane(plane).normal > 0.;
    of.have_one_face &= faces.insert({cells.cell_of_face(f), plane}).second;
    area[plane] += moments.area();
  }
  for (unsigned int k = 0; k < domain.n_planes(); ++k)
  {
    const auto face = domain.faces().polygon(k);
    largest(of.areas,
            area[k] / moments_of(dealii::make_array_view(face)).area() - 1.);
  }
  for (const Point<3> &corner : domain.faces().vertices)
    of.have_corners &= std::find(cells.vertices.begin(), cells.vertices.end(),
                                 corner) != cells.vertices.end();
}

Errors errors_of(const CellFaces &cells, const ConvexPolyhedron &domain)
{
  Errors of;
  double volume = 0.;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    const double of_cell = moments_of(cells, c).volume;
    of.are_wide &= of_cell > 0.;
    volume += of_cell;
    of.are_closed &= open_edges(cells, c).empty();
    for (unsigned int f = cells.first_face[c]; f < cells.first_face[c + 1]; ++f)
    {
      const auto corners = cells.corners(f);
      const std::set<unsigned int> different(corners.begin(), corners.end());
      of.are_simple &= different.size() >= 3;
      of.are_simple &= different.size() == corners.size();
      for (const unsigned int v : corners)
        for (unsigned int d = 0; d < cells.n_cells(); ++d)
          of.nearest = std::max(of.nearest,
                                (cells.vertices[v].distance(cells.centres[c]) -
                                 cells.vertices[v].distance(cells.centres[d])) /
                                    domain.extent());
    }
  }
  of.volume = volume / domain.volume() - 1.;
  const double cell_size = std::cbrt(domain.volume() / cells.n_cells());
  for (unsigned int f = 0; f < cells.n_faces(); ++f)
    of.width = std::min(of.width, width_of(cells.polygon(f)) / cell_size);
  judge_shared_faces(cells, domain.extent(), of);
  judge_boundary(cells, domain, of);
  return of;
}

/** The bounds of errors: rounding, and the resolution of vertices. */
struct ErrorBounds
{
  double volume = 1e-12, rounding = 4e-15, resolution = 2e-12, plane = 0.;
};

void check_errors(const Errors &of, const ErrorBounds &bounds)
{
  check_error("  volume", std::abs(of.volume), bounds.volume);
  check_error("  vertices in bisector planes", of.bisector, bounds.rounding);
  check_error("  no centre nearer to a vertex", of.nearest, bounds.resolution);
  check_error("  boundary in the planes", of.plane, bounds.plane);
  check_error("  area of the boundary", of.areas, bounds.volume);
  check("  closed cells, simple faces", of.are_closed && of.are_simple);
  check("  shared faces in opposite order", of.are_shared);
  check("  one face a pair, and a cell and plane", of.have_one_face);
  check("  corners of the domain", of.have_corners);
  check("  positive areas and volumes", of.are_wide);
  check("  no face narrower than is resolved", of.width > 1e-12);
}

PointList<3> listed(const std::vector<Point<3>> &points)
{
  PointList<3> list;
  list.points = points;
  return list;
}

CellFaces check_cells(const std::string &name,
                      const std::vector<Point<3>> &points,
                      const ConvexPolyhedron &domain,
                      const ErrorBounds &bounds = {})
{
  const CellFaces cells = voronoi_cells(listed(points), domain);
  std::cout << name << ": " << cells.n_cells() << " cells" << std::endl;
  check("  a cell for each point, in order",
        cells.n_cells() == points.size() && cells.centres == points);
  check_errors(errors_of(cells, domain), bounds);
  return cells;
}

const ConvexPolyhedron unit(Box{{0., 0., 0.}, {1., 1., 1.}});

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

std::vector<Point<3>> random_in_box(const unsigned int n,
                                    const unsigned int seed,
                                    const Box &box = {{0., 0., 0.},
                                                      {1., 1., 1.}})
{
  return random_points(n, seed, box).points;
}

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
  check_few_points();
  check_many_seeds();
  check_lattices();
  check_cospherical();
  check_extremes();
  check_polyhedra();
}

const RoomTest test("space_voronoi", run);
} // namespace test_space_voronoi
