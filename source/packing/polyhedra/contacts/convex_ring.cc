// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/contacts/convex_ring.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;

/** The distances of all corners from a line, with the extremes. */
struct CornerDistances
{
  CornerDistances(const ConvexRing &ring, const DirectedLine &line)
  {
    for (const RingCorner &corner : ring)
    {
      const double distance = line.distance(corner.at);
      of_corner.push_back(distance);
      least = std::min(least, distance);
      greatest = std::max(greatest, distance);
    }
  }

  boost::container::small_vector<double, 16> of_corner;
  double least = std::numeric_limits<double>::max();
  double greatest = std::numeric_limits<double>::lowest();
};

/** The part on the side of a line where sign times the distance is positive. */
ConvexRing half_beside(const ConvexRing &ring,
                       const CornerDistances &distances,
                       const double sign,
                       const double tolerance)
{
  ConvexRing half;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t next = i + 1 < n ? i + 1 : 0;
    const double here = distances.of_corner[i];
    const double there = distances.of_corner[next];
    if (sign * here >= -tolerance)
      half.push_back(ring[i]);
    if (std::min(here, there) < -tolerance && std::max(here, there) > tolerance)
    {
      // From the left, so that both halves have the same point to the last bit.
      const auto [left, right] =
          here > there ? std::pair(i, next) : std::pair(next, i);
      const Point<2> &p = ring[left].at, &q = ring[right].at;
      const double share = std::max(here, there) / std::abs(here - there);
      half.push_back({p + share * (q - p), invalid_index});
    }
  }
  return half;
}

/** True if a side is long enough for its direction to mean something. */
bool has_direction(const Point<2> &a, const Point<2> &b, const double tolerance)
{
  return a.distance_square(b) > tolerance * tolerance;
}

/** True if boxes around the two are apart, or touch. */
bool are_apart(const ConvexRing &one, const ConvexRing &other)
{
  for (unsigned int d = 0; d < 2; ++d)
  {
    const auto is_less = [d](const RingCorner &a, const RingCorner &b) {
      return a.at[d] < b.at[d];
    };
    const auto [low_one, high_one] =
        std::minmax_element(one.begin(), one.end(), is_less);
    const auto [low_other, high_other] =
        std::minmax_element(other.begin(), other.end(), is_less);
    if (high_one->at[d] <= low_other->at[d] ||
        high_other->at[d] <= low_one->at[d])
      return true;
  }
  return false;
}

/** Add the rest of one polygon, or the whole. */
void add_rest(ConvexRings &rests,
              const ConvexRing &whole,
              const ConvexRing &other,
              const double tolerance)
{
  if (are_apart(whole, other))
  {
    rests.push_back(whole);
    return;
  }
  const std::size_t n_before = rests.size();
  ConvexRing inside = whole;
  for (std::size_t i = 0; i < other.size() && !inside.empty(); ++i)
  {
    const Point<2> &a = other[i].at, &b = other[(i + 1) % other.size()].at;
    if (!has_direction(a, b, tolerance))
      continue;
    RingHalves halves = cut(inside, {a, b}, tolerance);
    if (!halves.right.empty() && width(halves.right) > tolerance)
      rests.push_back(halves.right);
    inside.swap(halves.left);
  }
  if (inside.empty() || !(width(inside) > tolerance))
  {
    rests.resize(n_before);
    rests.push_back(whole);
  }
}
} // namespace

RingHalves
cut(const ConvexRing &ring, const DirectedLine &line, const double tolerance)
{
  const CornerDistances distances(ring, line);
  if (!(distances.greatest > tolerance))
    return {{}, ring};
  if (!(distances.least < -tolerance))
    return {ring, {}};
  return {half_beside(ring, distances, 1., tolerance),
          half_beside(ring, distances, -1., tolerance)};
}

ConvexRing
common_part(ConvexRing ring, const ConvexRing &other, const double tolerance)
{
  for (std::size_t i = 0; i < other.size() && !ring.empty(); ++i)
  {
    const Point<2> &a = other[i].at, &b = other[(i + 1) % other.size()].at;
    if (!has_direction(a, b, tolerance))
      continue;
    const DirectedLine line(a, b);
    const CornerDistances distances(ring, line);
    if (!(distances.greatest > tolerance))
      ring.clear();
    else if (distances.least < -tolerance)
      ring = half_beside(ring, distances, 1., tolerance);
  }
  return ring;
}

ConvexRings without(const ConvexRings &rings,
                    const ConvexRing &other,
                    const double tolerance)
{
  ConvexRings rests;
  for (const ConvexRing &ring : rings)
    add_rest(rests, ring, other, tolerance);
  return rests;
}

double area(const ConvexRing &ring)
{
  double twice = 0.;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    twice += cross(ring[i].at - ring[0].at, ring[i + 1].at - ring[0].at);
  return 0.5 * twice;
}

double width(const ConvexRing &ring)
{
  // The least is attained with one of the lines along a side.
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Point<2> &a = ring[i].at, &b = ring[(i + 1) % ring.size()].at;
    if (a == b)
      continue;
    const DirectedLine line(a, b);
    double farthest = 0.;
    for (const RingCorner &corner : ring)
      farthest = std::max(farthest, line.distance(corner.at));
    least = std::min(least, farthest);
  }
  return ring.size() < 3 || least == std::numeric_limits<double>::max() ? 0.
                                                                        : least;
}
} // namespace Voussoir
