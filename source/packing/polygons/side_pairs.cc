// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/packing/polygons/side_pairs.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

constexpr double unbounded = std::numeric_limits<double>::max();

/** Keep of an interval where a linear function is between two values. */
void clip(double &low,
          double &high,
          const std::array<double, 2> &values,
          const double least,
          const double greatest)
{
  if (!(high > low))
    return;
  const double slope = (values[1] - values[0]) / (high - low);
  const double start = low;
  for (const auto &[limit, sign] :
       {std::pair(greatest, 1.), std::pair(least, -1.)})
  {
    const double at_low = sign * (values[0] - limit),
                 at_high = sign * (values[1] - limit);
    if (at_low > 0. && at_high > 0.)
      high = low;
    else if (at_low > 0.)
      low = std::max(low, start + (limit - values[0]) / slope);
    else if (at_high > 0.)
      high = std::min(high, start + (limit - values[0]) / slope);
  }
}

/** The box around some points, wider by a margin on all sides. */
dealii::BoundingBox<2> box_around(const std::vector<Point<2>> &points,
                                  const double margin)
{
  dealii::BoundingBox<2> box(points);
  box.extend(margin);
  return box;
}
} // namespace

PolygonSide::PolygonSide(const unsigned int cell,
                         const Point<2> &start,
                         const Point<2> &end)
    : cell(cell), start(start), end(end), length(start.distance(end))
{
  along = (end - start) / length;
}

std::vector<PolygonSide> sides_of(const PolygonList &polygons)
{
  std::vector<PolygonSide> sides;
  for (unsigned int c = 0; c < polygons.polygons.size(); ++c)
  {
    const auto &ring = polygons.polygons[c].ring;
    for (std::size_t i = 0; i < ring.size(); ++i)
      sides.emplace_back(c, ring[i], ring[(i + 1) % ring.size()]);
  }
  return sides;
}

std::vector<PolygonSide> sides_of(const CellLoops &cells)
{
  std::vector<PolygonSide> sides;
  sides.reserve(cells.loops.size());
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    for (unsigned int i = 0; i < cells.n_sides(c); ++i)
      sides.emplace_back(c, cells.vertex(c, i), cells.vertex(c, i + 1));
  return sides;
}

SidePair::SidePair(const std::vector<PolygonSide> &sides,
                   const std::array<std::size_t, 2> &side,
                   const Tensor<1, 2> &along)
    : side(side), cells({{sides[side[0]].cell, sides[side[1]].cell}}),
      origin(sides[side[0]].start), along(along)
{
  for (unsigned int k = 0; k < 2; ++k)
  {
    const PolygonSide &of = sides[side[k]];
    begin[k] = coordinate(of.start);
    slope[k] = of.along * along;
    start_height[k] = cross(of.start - origin, along);
    rise[k] = cross(of.along, along);
  }
  // The second side runs against the line.
  low = std::max(0., coordinate(1, sides[side[1]].length));
  high = std::min(coordinate(0, sides[side[0]].length), begin[1]);
}

Point<2> SidePair::place(const double s, const double height) const
{
  return origin + s * along + height * Tensor<1, 2>({along[1], -along[0]});
}

Point<2> SidePair::middle() const
{
  const double s = 0.5 * (low + high);
  return place(s, 0.5 * (height(0, s) + height(1, s)));
}

void SidePair::keep_gaps(const double least, const double greatest)
{
  clip(low, high, {{gap(low), gap(high)}}, least, greatest);
}

std::vector<Point<2>> SidePair::outline(const double margin) const
{
  SidePair inner = *this;
  inner.low += margin;
  inner.high -= margin;
  inner.keep_gaps(2. * margin, unbounded);
  if (!(inner.length() > 0.))
    return {};
  const auto corner = [&](const unsigned int k, const double s) {
    return place(s, height(k, s) + (k == 0 ? margin : -margin));
  };
  return {corner(0, inner.low), corner(1, inner.low), corner(1, inner.high),
          corner(0, inner.high)};
}

std::optional<SidePair::Interval>
SidePair::shadow(const Point<2> &a,
                 const Point<2> &b,
                 const std::array<double, 2> &margins) const
{
  const double s_a = coordinate(a), s_b = coordinate(b);
  const double h_a = cross(a - origin, along), h_b = cross(b - origin, along);
  const auto coordinate_at = [&](const double u) {
    return s_a + u * (s_b - s_a);
  };
  const auto height_at = [&](const double u) { return h_a + u * (h_b - h_a); };
  // The part of the segment, from 0 to 1, that is in the strip.
  double first = 0., last = 1.;
  const auto keep = [&](const auto &value, double least, double greatest) {
    clip(first, last, {{value(first), value(last)}}, least, greatest);
  };
  keep(coordinate_at, low, high);
  keep([&](double u) { return height_at(u) - height(0, coordinate_at(u)); },
       margins[0], unbounded);
  keep([&](double u) { return height(1, coordinate_at(u)) - height_at(u); },
       margins[1], unbounded);
  if (!(last > first))
    return {};
  const auto [from, to] =
      std::minmax({coordinate_at(first), coordinate_at(last)});
  return Interval{{from, to}};
}

std::vector<SidePair> SidePair::without(std::vector<Interval> taken,
                                        const double shortest) const
{
  std::sort(taken.begin(), taken.end());
  std::vector<SidePair> left;
  SidePair part = *this;
  const auto add_up_to = [&](const double end) {
    part.high = end;
    if (part.length() > shortest)
      left.push_back(part);
  };
  for (std::size_t i = 0; i < taken.size();)
  {
    auto [from, to] = taken[i];
    for (++i; i < taken.size() && taken[i][0] <= to; ++i)
      to = std::max(to, taken[i][1]);
    if (!(to - from > shortest))
      continue;
    add_up_to(from);
    part.low = to;
  }
  add_up_to(high);
  return left;
}

std::optional<SidePair> facing_pair(const std::vector<PolygonSide> &sides,
                                    const std::array<std::size_t, 2> &side,
                                    const FacingLimits &limits)
{
  const PolygonSide &one = sides[side[0]], &other = sides[side[1]];
  // The half of an angle that is small has a sine of full precision.
  const double half_sine = 0.5 * (one.along + other.along).norm();
  if (!(half_sine <= std::sin(0.5 * limits.angle)))
    return {};
  const Tensor<1, 2> sum = one.along - other.along;
  SidePair pair(sides, side, sum / sum.norm());
  if (!(pair.length() > limits.tolerance))
    return {};
  pair.keep_gaps(-limits.tolerance, limits.joint_width + limits.tolerance);
  if (!(pair.length() > limits.tolerance))
    return {};
  return pair;
}

SideTree::SideTree(const std::vector<PolygonSide> &sides,
                   const double tolerance)
    : sides(sides), tolerance(tolerance), boxes([&] {
        std::vector<Box> all;
        all.reserve(sides.size());
        for (const PolygonSide &side : sides)
          all.push_back(box_around({side.start, side.end}, tolerance));
        return all;
      }()),
      tree(dealii::pack_rtree_of_indices(boxes))
{}

std::vector<std::size_t> SideTree::near(const std::size_t side,
                                        const double distance) const
{
  Box box = boxes[side];
  box.extend(distance);
  std::vector<std::size_t> found;
  tree.query(boost::geometry::index::intersects(box),
             std::back_inserter(found));
  std::sort(found.begin(), found.end());
  return found;
}

/** What a side of a block in a strip covers of it. */
std::optional<SidePair::Interval>
SideTree::shadow(const SidePair &pair, const PolygonSide &side) const
{
  // A side of the two cells covers what it enters. Another block may also fill
  // the strip: the side that it turns to one of the two may lie on that.
  std::array<double, 2> margins = {{tolerance, tolerance}};
  if (side.cell != pair.cells[0] && side.cell != pair.cells[1])
    margins[side.along * pair.direction() > 0. ? 1 : 0] = -tolerance;
  return pair.shadow(side.start, side.end, margins);
}

std::vector<SidePair> SideTree::uncovered(const SidePair &pair) const
{
  const std::vector<Point<2>> outline = pair.outline(tolerance);
  if (outline.empty())
    return {pair};
  std::vector<SidePair::Interval> taken;
  for (auto k = tree.qbegin(boost::geometry::index::intersects(
           box_around(outline, 2. * tolerance)));
       k != tree.qend(); ++k)
    if (const auto covered = shadow(pair, sides[*k]))
      taken.push_back(*covered);
  std::vector<SidePair> parts = pair.without(std::move(taken), tolerance);
  const auto is_slot = [&](const SidePair &part) {
    return (part.low > pair.low || part.high < pair.high) &&
           part.length() < part.least_gap() - tolerance;
  };
  parts.erase(std::remove_if(parts.begin(), parts.end(), is_slot), parts.end());
  return parts;
}
} // namespace Voussoir
