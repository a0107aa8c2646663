// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/convex_overlap.h>
#include <voussoir/packing/polygons/crossing_pairs.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Ring = std::vector<Point<2>>;
using Box = dealii::BoundingBox<2>;
using Interval = SidePair::Interval;

/** The cosine of the angle between strips from which on they cross. */
constexpr double half_right = 0.70710678118654752;

/** What a polygon covers of the line of a strip. */
Interval extent(const SidePair &pair, const Ring &ring)
{
  Interval interval = {{pair.coordinate(ring[0]), pair.coordinate(ring[0])}};
  for (const Point<2> &p : ring)
  {
    interval[0] = std::min(interval[0], pair.coordinate(p));
    interval[1] = std::max(interval[1], pair.coordinate(p));
  }
  return interval;
}
} // namespace

std::vector<SidePair> without_crossings(const std::vector<SidePair> &pairs,
                                        const double tolerance)
{
  // Half of the tolerance each, so that strips may overlap by that much, and
  // what it leaves at the end of a strip vanishes.
  const double margin_of_strips = 0.5 * tolerance;
  // Empty strips, of sides that touch, are crossed by nothing; a box that is
  // not empty stands for them.
  std::vector<Box> boxes;
  boxes.reserve(pairs.size());
  for (const SidePair &pair : pairs)
  {
    const Ring ring = pair.outline(margin_of_strips);
    boxes.push_back(ring.empty() ? Box({pair.middle(), pair.middle()})
                                 : Box(ring));
  }
  const auto tree = dealii::pack_rtree_of_indices(boxes);

  std::vector<std::vector<Interval>> taken(pairs.size());
  /** Take from @p wide where @p narrow is narrower by more than a margin. */
  const auto take = [&](const std::size_t wide, const std::size_t narrow,
                        const Ring &common, const double margin) {
    const Ring part = part_where(common, [&](const Point<2> &p) {
      const SidePair &a = pairs[wide], &b = pairs[narrow];
      return a.gap(a.coordinate(p)) - b.gap(b.coordinate(p)) - margin;
    });
    if (!part.empty())
      taken[wide].push_back(extent(pairs[wide], part));
  };
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const Ring ring = pairs[i].outline(margin_of_strips);
    if (ring.empty())
      continue;
    for (auto j = tree.qbegin(boost::geometry::index::intersects(boxes[i]));
         j != tree.qend(); ++j)
    {
      if (*j <= i)
        continue;
      const Ring other = pairs[*j].outline(margin_of_strips);
      if (other.empty() || !(overlap_depth(ring, other, 0.) > 0.))
        continue;
      const Ring common = common_part(ring, other);
      const bool do_cross =
          std::abs(pairs[i].direction() * pairs[*j].direction()) < half_right;
      const double margin = do_cross ? tolerance : 0.;
      take(i, *j, common, margin);
      take(*j, i, common, margin);
    }
  }
  std::vector<SidePair> left;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (const SidePair &part : pairs[i].without(taken[i], tolerance))
      left.push_back(part);
  return left;
}
} // namespace Voussoir
