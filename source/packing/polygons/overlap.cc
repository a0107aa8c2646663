// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/polygon_checks.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>

#include <algorithm>
#include <limits>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Ring = std::vector<Point<2>>;
using Box = dealii::BoundingBox<2>;

/**
 * The distance, relative to the lengths of the sides at a vertex, that the
 * vertex may lie inside its neighbours' chord by rounding alone.
 */
constexpr double convexity_tolerance = 1e-12;

/** Negative to the right of the line from @p a to @p b; length times length. */
double left_of(const Point<2> &a, const Point<2> &b, const Point<2> &p)
{
  return cross(b - a, p - a);
}

bool is_convex(const Ring &ring)
{
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point<2> &a = ring[i], &b = ring[(i + 1) % n], &c = ring[(i + 2) % n];
    const double longer = std::max(a.distance_square(b), b.distance_square(c));
    if (left_of(a, b, c) < -convexity_tolerance * longer)
      return false;
  }
  return true;
}

/** Cut a simple polygon into convex ones. */
std::vector<Ring> convex_pieces(const Ring &ring)
{
  if (is_convex(ring))
    return {ring};
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Traits = CGAL::Partition_traits_2<Kernel>;
  std::vector<Kernel::Point_2> points;
  for (const Point<2> &p : ring)
    points.emplace_back(p[0], p[1]);
  std::vector<Traits::Polygon_2> parts;
  CGAL::approx_convex_partition_2(points.begin(), points.end(),
                                  std::back_inserter(parts), Traits());
  std::vector<Ring> pieces(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const Kernel::Point_2 &p : parts[i])
      pieces[i].emplace_back(p.x(), p.y());
  return pieces;
}

/** The least distance that @p b reaches over a side of @p a. */
double least_reach(const Ring &a, const Ring &b, const double enough)
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < a.size() && least > enough; ++i)
  {
    const Point<2> &start = a[i], &end = a[(i + 1) % a.size()];
    double inside_a = 0., inside_b = std::numeric_limits<double>::lowest();
    for (const Point<2> &p : a)
      inside_a = std::min(inside_a, left_of(start, end, p));
    for (const Point<2> &p : b)
      inside_b = std::max(inside_b, left_of(start, end, p));
    least = std::min(least, (inside_b - inside_a) / start.distance(end));
  }
  return least;
}

/**
 * The depth of the overlap of two convex polygons; of one at most @p enough,
 * only that it is no more.
 */
double depth(const Ring &a, const Ring &b, const double enough)
{
  const double reach = least_reach(a, b, enough);
  return reach > enough ? std::min(reach, least_reach(b, a, enough)) : reach;
}

/** The middle of what two convex polygons have in common. */
Point<2> place_of_overlap(Ring common, const Ring &other)
{
  for (std::size_t i = 0; i < other.size(); ++i)
  {
    const Point<2> &start = other[i], &end = other[(i + 1) % other.size()];
    Ring kept;
    for (std::size_t j = 0; j < common.size(); ++j)
    {
      const Point<2> &p = common[j], &q = common[(j + 1) % common.size()];
      const double at_p = left_of(start, end, p), at_q = left_of(start, end, q);
      if (at_p >= 0.)
        kept.push_back(p);
      if ((at_p > 0. && at_q < 0.) || (at_p < 0. && at_q > 0.))
        kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    if (!kept.empty()) // else rounding on a side that is the same in both
      common.swap(kept);
  }
  Point<2> sum;
  for (const Point<2> &p : common)
    sum += p;
  return sum / static_cast<double>(common.size());
}

/** One convex piece of a cell. */
struct Piece
{
  unsigned int cell;
  Ring ring;
};

void refuse_overlap(const PolygonList &polygons,
                    const Piece &a,
                    const Piece &b,
                    const double tolerance)
{
  const double overlap = depth(a.ring, b.ring, tolerance);
  if (!(overlap > tolerance))
    return;
  const PolygonList::Polygon &other = polygons.polygons[a.cell];
  polygons.refuse(
      b.cell, text("overlaps cell ", a.cell, " (", polygons.record_name, ' ',
                   other.record, ") at ",
                   text_of_point(place_of_overlap(a.ring, b.ring)), " by ",
                   overlap, ", more than the matching tolerance ", tolerance,
                   "; redraw one of them, or delete it if it is there "
                   "twice."));
}
} // namespace

void refuse_overlaps(const PolygonList &polygons, const double tolerance)
{
  std::vector<Piece> pieces;
  std::vector<Box> boxes;
  for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
    for (const Ring &ring : convex_pieces(polygons.polygons[c].ring))
    {
      pieces.push_back({c, ring});
      boxes.emplace_back(ring);
    }

  const auto tree = dealii::pack_rtree_of_indices(boxes);
  std::vector<std::size_t> near;
  for (std::size_t b = 0; b < pieces.size(); ++b)
  {
    near.clear();
    tree.query(boost::geometry::index::intersects(boxes[b]),
               std::back_inserter(near));
    std::sort(near.begin(), near.end()); // so that messages do not depend on it
    for (const std::size_t a : near)
      if (a < b && pieces[a].cell != pieces[b].cell)
        refuse_overlap(polygons, pieces[a], pieces[b], tolerance);
  }
}
} // namespace Voussoir
