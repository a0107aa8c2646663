// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/random.h>
#include <voussoir/packing/polyhedra/voronoi/random_points.h>
#include <voussoir/packing/voronoi/curve_order.h>
#include <voussoir/packing/voronoi/point_source.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>
#include <vector>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** The least number of tetrahedra into which the polyhedron is cut. */
constexpr double least_tetrahedra = 4096.;

using TetrahedronCorners = std::array<Point<3>, 4>;

/**
 * Add to a @p source a tetrahedron, cut @p n_times into eight of equal volume:
 * one at each corner, four around a diagonal of the octahedron between them.
 */
void add_tetrahedra(PointSource<3> &source,
                    const TetrahedronCorners &corners,
                    const double volume,
                    const unsigned int n_times)
{
  if (n_times == 0)
  {
    source.add(corners, volume);
    return;
  }
  const auto middle = [&](const unsigned int i, const unsigned int j) {
    return corners[i] + 0.5 * (corners[j] - corners[i]);
  };
  const Point<3> m01 = middle(0, 1), m02 = middle(0, 2), m03 = middle(0, 3),
                 m12 = middle(1, 2), m13 = middle(1, 3), m23 = middle(2, 3);
  const std::array<TetrahedronCorners, 8> parts = {
      {{{corners[0], m01, m02, m03}},
       {{m01, corners[1], m12, m13}},
       {{m02, m12, corners[2], m23}},
       {{m03, m13, m23, corners[3]}},
       {{m02, m13, m01, m03}},
       {{m02, m13, m03, m23}},
       {{m02, m13, m23, m12}},
       {{m02, m13, m12, m01}}}};
  for (const TetrahedronCorners &part : parts)
    add_tetrahedra(source, part, volume / 8., n_times - 1);
}

/** By the tetrahedra between the middle and triangles of the faces. */
PointSource<3> source_in_polyhedron(const ConvexPolyhedron &polyhedron,
                                    const CellSize<3> &size)
{
  const Point<3> &middle = polyhedron.middle();
  const CellFaces &faces = polyhedron.faces();
  const double n_triangles =
      static_cast<double>(faces.loops.size()) - 2. * faces.n_faces();
  unsigned int n_times = 0;
  while (n_triangles * std::pow(8., n_times) < least_tetrahedra)
    ++n_times;
  PointSource<3> source(size, middle);
  for (unsigned int k = 0; k < faces.n_faces(); ++k)
    for (unsigned int i = 1; i + 1 < faces.n_corners(k); ++i)
    {
      const TetrahedronCorners corners = {{middle, faces.vertex(k, 0),
                                           faces.vertex(k, i),
                                           faces.vertex(k, i + 1)}};
      const double volume =
          (corners[1] - middle) *
          cross_product_3d(corners[2] - middle, corners[3] - middle) / 6.;
      add_tetrahedra(source, corners, volume, n_times);
    }
  return source;
}
} // namespace

PointList<3>
random_points(const unsigned int n, const unsigned int seed, const Box &box)
{
  Random random(seed);
  PointList<3> list;
  list.points.resize(n);
  for (Point<3> &p : list.points)
    for (unsigned int i = 0; i < 3; ++i)
      p[i] = box.lower[i] + random() * (box.upper[i] - box.lower[i]);
  order_along_curve(list.points);
  return list;
}

PointList<3> random_points(const unsigned int n,
                           const unsigned int seed,
                           const ConvexPolyhedron &polyhedron,
                           const CellSize<3> &size)
{
  PointList<3> list;
  list.points = source_in_polyhedron(polyhedron, size).draw(n, seed);
  order_along_curve(list.points);
  return list;
}
} // namespace Voussoir
