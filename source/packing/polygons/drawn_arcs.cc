// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polygons/arc.h>
#include <voussoir/packing/polygons/drawn_arcs.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Points = std::vector<Point<2>>;

/** The difference of bulges by which a curve is no arc, relative to them. */
constexpr double noncircular = 1e-6;

/** The rounding of vertices that are computed, over the largest coordinate. */
constexpr double relative_rounding = 1e-11;

/** The ends of an arc are one, if they are this part of its size apart. */
constexpr double whole_circle = 1e-9;

/** Goes from one vertex of a coarse chain to the next. */
class ChainReader
{
public:
  ChainReader(const Points &fine, const Points &usual)
      : fine(fine), usual(usual)
  {
    for (const Point<2> &p : usual)
      rounding = std::max({rounding, std::abs(p[0]), std::abs(p[1])});
    rounding *= relative_rounding;
  }

  /** False if @p coarse does not lead through the other chains. */
  bool read(const Points &coarse)
  {
    std::size_t in_fine = 0, in_usual = 0;
    for (const Point<2> &p : coarse)
    {
      const bool is_first = chain.points.empty();
      const std::size_t next = place_of(p, fine, is_first ? 0 : in_fine + 1),
                        other = place_of(p, usual, is_first ? 0 : in_usual + 1);
      if (next == fine.size() || other == usual.size())
        return false;
      if (is_first)
        chain.add(p);
      else if (next == in_fine + 1)
        add_side(p);
      else if (!add_curve(in_fine, next))
        add_chords(in_usual, other);
      in_fine = next;
      in_usual = other;
    }
    return true;
  }

  DrawnChain chain;

private:
  bool are_one(const Point<2> &p, const Point<2> &q) const
  {
    return p.distance(q) <= rounding;
  }

  std::size_t place_of(const Point<2> &p,
                       const Points &among,
                       const std::size_t first) const
  {
    std::size_t k = first;
    while (k < among.size() && !are_one(p, among[k]))
      ++k;
    return std::min(k, among.size());
  }

  /** A straight side, but none from the end of an arc, which is computed, to
   * the vertex that was drawn there. */
  void add_side(const Point<2> &end)
  {
    if (chain.bulges.empty() || chain.bulges.back() == 0. ||
        !are_one(chain.points.back(), end))
      chain.add(end);
  }

  /** Go on along an arc or a circle in fine points; false if it is neither. */
  bool add_curve(const std::size_t first, const std::size_t last)
  {
    const std::size_t middle = (first + last) / 2;
    const bool is_whole = are_one(fine[first], fine[last]);
    if (is_whole ? !is_arc(first, middle) || !is_arc(middle, last)
                 : !is_arc(first, last))
      return false;
    // Nor one from a vertex to the start of an arc.
    if (const std::size_t n = chain.points.size();
        n > 1 && chain.bulges.back() == 0. &&
        are_one(chain.points[n - 2], chain.points[n - 1]))
    {
      chain.points.pop_back();
      chain.bulges.pop_back();
    }
    if (is_whole)
    {
      chain.add_arc(fine[(first + middle) / 2], fine[middle]);
      chain.add_arc(fine[(middle + last) / 2], fine[last]);
    }
    else
      chain.add_arc(fine[middle], fine[last]);
    return true;
  }

  bool is_arc(const std::size_t first, const std::size_t last) const
  {
    const std::size_t n = last - first;
    if (n < 4)
      return true; // too short to tell
    const auto bulge_at = [&](const std::size_t quarters) {
      return bulge_through(fine[first], fine[first + quarters * n / 4],
                           fine[last]);
    };
    const double bulge = bulge_at(2);
    return std::max(std::abs(bulge_at(1) - bulge),
                    std::abs(bulge_at(3) - bulge)) <=
           noncircular * (1. + bulge * bulge);
  }

  void add_chords(const std::size_t first, const std::size_t last)
  {
    chain.has_other_curves = true;
    for (std::size_t k = first + 1; k <= last; ++k)
      chain.add(usual[k]);
  }

  const Points &fine, &usual;
  double rounding = 0.;
};
} // namespace

bool DrawnChain::has_arcs() const
{
  return std::any_of(bulges.begin(), bulges.end(),
                     [](const double bulge) { return bulge != 0.; });
}

void DrawnChain::add(const Point<2> &point, const double bulge)
{
  if (!points.empty())
    bulges.push_back(bulge);
  points.push_back(point);
}

void DrawnChain::add_arc(const Point<2> &middle, const Point<2> &end)
{
  const Point<2> start = points.back();
  if (middle == start || middle == end)
    add(end);
  else if (start.distance(end) <= whole_circle * start.distance(middle))
  {
    // A half each; which way round is not told, and does not matter.
    add(middle, 1.);
    add(end, 1.);
  }
  else
    add(end, bulge_through(start, middle, end));
}

void DrawnChain::append(const DrawnChain &other)
{
  for (std::size_t i = points.empty() ? 0 : 1; i < other.points.size(); ++i)
    add(other.points[i], i == 0 ? 0. : other.bulges[i - 1]);
  has_other_curves |= other.has_other_curves;
}

DrawnChain
chain_between(const Points &coarse, const Points &fine, const Points &usual)
{
  ChainReader reader(fine, usual);
  if (reader.read(coarse))
    return reader.chain;
  DrawnChain straight;
  for (const Point<2> &p : usual)
    straight.add(p);
  straight.has_other_curves = true;
  return straight;
}
} // namespace Voussoir
