// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/packing/convex_pieces.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/partition_2.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

std::vector<Kernel::Point_2> points_of(const std::vector<Point<2>> &ring)
{
  std::vector<Kernel::Point_2> points;
  for (const Point<2> &p : ring)
    points.emplace_back(p[0], p[1]);
  return points;
}

/**
 * The distance, relative to the lengths of the sides at a vertex, that the
 * vertex may lie inside its neighbours' chord by rounding alone.
 */
constexpr double convexity_tolerance = 1e-12;

bool is_convex(const std::vector<Point<2>> &ring)
{
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point<2> &a = ring[i], &b = ring[(i + 1) % n], &c = ring[(i + 2) % n];
    const double longer = std::max(a.distance_square(b), b.distance_square(c));
    if (cross(b - a, c - a) < -convexity_tolerance * longer)
      return false;
  }
  return true;
}
} // namespace

bool is_simple(const std::vector<Point<2>> &ring)
{
  const std::vector<Kernel::Point_2> points = points_of(ring);
  return CGAL::is_simple_2(points.begin(), points.end(), Kernel());
}

bool is_inside(const Point<2> &p, const std::vector<Point<2>> &ring)
{
  const std::vector<Kernel::Point_2> points = points_of(ring);
  return CGAL::bounded_side_2(points.begin(), points.end(),
                              Kernel::Point_2(p[0], p[1]),
                              Kernel()) == CGAL::ON_BOUNDED_SIDE;
}

std::vector<std::vector<unsigned int>>
convex_pieces(const std::vector<Point<2>> &ring)
{
  using Places = CGAL::Pointer_property_map<Kernel::Point_2>::const_type;
  using Traits = CGAL::Partition_traits_2<Kernel, Places>;
  std::vector<unsigned int> all(ring.size());
  std::iota(all.begin(), all.end(), 0);
  if (is_convex(ring))
    return {all};
  const std::vector<Kernel::Point_2> points = points_of(ring);
  std::vector<Traits::Polygon_2> parts;
  CGAL::approx_convex_partition_2(all.begin(), all.end(),
                                  std::back_inserter(parts),
                                  Traits(CGAL::make_property_map(points)));
  std::vector<std::vector<unsigned int>> pieces;
  for (const Traits::Polygon_2 &part : parts)
    pieces.emplace_back(part.container().begin(), part.container().end());
  return pieces;
}

std::vector<Point<2>> ring_of(const Packing<2> &packing,
                              const unsigned int cell)
{
  std::vector<Point<2>> ring;
  for (unsigned int i = 0; i < packing.n_sides(cell); ++i)
    ring.push_back(packing.vertex(cell, i));
  return ring;
}

Point<2> centroid(const std::vector<Point<2>> &ring)
{
  // By triangles from the first vertex, so that a distant origin cancels
  // nothing.
  double area = 0.;
  dealii::Tensor<1, 2> moment;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
  {
    const dealii::Tensor<1, 2> a = ring[i] - ring[0], b = ring[i + 1] - ring[0];
    area += 0.5 * cross(a, b);
    moment += cross(a, b) / 6. * (a + b);
  }
  return ring[0] + moment / area;
}
} // namespace Voussoir
