// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_packing_space_voronoi_checks_h
#define voussoir_tests_packing_space_voronoi_checks_h

// The properties of Voronoi cells in space, whatever the points: cells are
// closed and fill the domain, faces bisect the line between two centres, and no
// centre is nearer to a vertex than that of its cell. As the part of the domain
// that is nearest to a centre is convex, these are all that a Voronoi cell is.

#include <voussoir/base/random.h>
#include <voussoir/packing/polyhedra/cell_moments.h>
#include <voussoir/packing/polyhedra/space_polygons.h>
#include <voussoir/packing/polyhedra/voronoi/random_points.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi_cells.h>

#include "tests.h"
#include <limits>
#include <set>

/** What the tests of Voronoi cells in space share. */
namespace space_voronoi_checks
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

/** Make @p value at least as large as the other, and infinite for a NaN. */
inline void largest(double &value, const double other)
{
  value = std::isnan(other) ? std::numeric_limits<double>::infinity()
                            : std::max(value, std::abs(other));
}

/** The largest distance of a corner from the longest diagonal. */
inline double width_of(const std::vector<Point<3>> &polygon)
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
inline void
judge_shared_faces(const CellFaces &cells, const double size, Errors &of)
{
  using Pair = std::array<unsigned int, 2>;
  std::set<Pair> pairs;
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
    of.have_one_face &= pairs.insert(Pair{{c, d}}).second;
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
inline void judge_boundary(const CellFaces &cells,
                           const ConvexPolyhedron &domain,
                           Errors &of)
{
  std::vector<bool> is_shared(cells.n_faces(), false);
  for (const auto &pair : cells.shared)
    is_shared[pair[0]] = is_shared[pair[1]] = true;
  std::vector<double> area(domain.n_planes(), 0.);
  using Pair = std::array<unsigned int, 2>;
  std::set<Pair> faces;
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
    of.have_one_face &=
        faces.insert(Pair{{cells.cell_of_face(f), plane}}).second;
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

inline Errors errors_of(const CellFaces &cells, const ConvexPolyhedron &domain)
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
        {
          const double excess = (cells.vertices[v].distance(cells.centres[c]) -
                                 cells.vertices[v].distance(cells.centres[d])) /
                                domain.extent();
          if (!(excess <= 0.))
            largest(of.nearest, excess);
        }
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

inline void check_errors(const Errors &of, const ErrorBounds &bounds)
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

inline PointList<3> listed(const std::vector<Point<3>> &points)
{
  PointList<3> list;
  list.points = points;
  return list;
}

inline CellFaces check_cells(const std::string &name,
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

inline const ConvexPolyhedron unit(Box{{0., 0., 0.}, {1., 1., 1.}});

inline std::vector<Point<3>> random_in_box(const unsigned int n,
                                           const unsigned int seed,
                                           const Box &box = {{0., 0., 0.},
                                                             {1., 1., 1.}})
{
  return random_points(n, seed, box).points;
}
} // namespace space_voronoi_checks

#endif
