// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/random.h>
#include <voussoir/packing/voronoi/curve_order.h>
#include <voussoir/packing/voronoi/point_source.h>
#include <voussoir/packing/voronoi/random_points.h>

#include <cmath>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** The least number of triangles into which the polygon is cut. */
constexpr unsigned int least_triangles = 4096;

/** Add to a @p source a triangle, cut into n_cuts^2 equal ones. */
void add_triangles(PointSource<2> &source,
                   const Simplex<2> &whole,
                   const unsigned int n_cuts)
{
  const double area = whole.measure / (n_cuts * n_cuts);
  const auto node = [&](const unsigned int i, const unsigned int j) {
    return whole.at({{1. * i / n_cuts, 1. * j / n_cuts}});
  };
  for (unsigned int i = 0; i < n_cuts; ++i)
    for (unsigned int j = 0; i + j < n_cuts; ++j)
    {
      source.add({{node(i, j), node(i + 1, j), node(i, j + 1)}}, area);
      if (i + j + 1 < n_cuts)
        source.add({{node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}},
                   area);
    }
}

PointSource<2> source_in_polygon(const ConvexPolygon &polygon,
                                 const CellSize<2> &size)
{
  const unsigned int n = polygon.n_sides();
  Point<2> middle;
  for (unsigned int i = 0; i < n; ++i)
    middle += polygon.vertex(i) / n;
  PointSource<2> source(size, middle);

  const unsigned int n_cuts = std::ceil(std::sqrt(1. * least_triangles / n));
  for (unsigned int i = 0; i < n; ++i)
  {
    const double area = -0.5 * polygon.beyond(middle, i) *
                        polygon.vertex(i).distance(polygon.vertex(i + 1));
    add_triangles(
        source,
        {{{middle, polygon.vertex(i), polygon.vertex(i + 1)}}, area, 0.},
        n_cuts);
  }
  return source;
}
} // namespace

PointList<2> random_points(const unsigned int n,
                           const unsigned int seed,
                           const Rectangle &rectangle)
{
  Random random(seed);
  PointList<2> list;
  list.points.resize(n);
  for (Point<2> &p : list.points)
    for (unsigned int i = 0; i < 2; ++i)
      p[i] = rectangle.lower_left[i] +
             random() * (rectangle.upper_right[i] - rectangle.lower_left[i]);
  order_along_curve(list.points);
  return list;
}

PointList<2> random_points(const unsigned int n,
                           const unsigned int seed,
                           const ConvexPolygon &polygon,
                           const CellSize<2> &size)
{
  PointList<2> list;
  list.points = source_in_polygon(polygon, size).draw(n, seed);
  order_along_curve(list.points);
  return list;
}
} // namespace Voussoir
