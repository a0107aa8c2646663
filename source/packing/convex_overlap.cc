// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/packing/convex_overlap.h>

#include <algorithm>
#include <limits>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Ring = std::vector<Point<2>>;

/** Negative to the right of the line from @p a to @p b; length times length. */
double left_of(const Point<2> &a, const Point<2> &b, const Point<2> &p)
{
  return cross(b - a, p - a);
}

/** The least distance that @p b reaches over a side of @p a. */
double least_reach(const Ring &a, const Ring &b, const double enough)
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < a.size() && least > enough; ++i)
  {
    const Point<2> &start = a[i], &end = a[(i + 1) % a.size()];
    const double length = start.distance(end);
    if (!(length > 0.))
      continue;
    double inside_a = 0., inside_b = std::numeric_limits<double>::lowest();
    for (const Point<2> &p : a)
      inside_a = std::min(inside_a, left_of(start, end, p));
    for (const Point<2> &p : b)
      inside_b = std::max(inside_b, left_of(start, end, p));
    least = std::min(least, (inside_b - inside_a) / length);
  }
  return least;
}
} // namespace

double overlap_depth(const Ring &a, const Ring &b, const double enough)
{
  const double reach = least_reach(a, b, enough);
  return reach > enough ? std::min(reach, least_reach(b, a, enough)) : reach;
}

Ring common_part(Ring common, const Ring &other)
{
  for (std::size_t i = 0; i < other.size(); ++i)
  {
    Ring kept = part_where(common, [&](const Point<2> &p) {
      return left_of(other[i], other[(i + 1) % other.size()], p);
    });
    if (!kept.empty()) // else rounding on a side that is the same in both
      common.swap(kept);
  }
  return common;
}

Ring part_where(const Ring &ring,
                const std::function<double(const Point<2> &)> &function)
{
  Ring kept;
  for (std::size_t j = 0; j < ring.size(); ++j)
  {
    const Point<2> &p = ring[j], &q = ring[(j + 1) % ring.size()];
    const double at_p = function(p), at_q = function(q);
    if (at_p >= 0.)
      kept.push_back(p);
    if ((at_p > 0. && at_q < 0.) || (at_p < 0. && at_q > 0.))
      kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}
} // namespace Voussoir
