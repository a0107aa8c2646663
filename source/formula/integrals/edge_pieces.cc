// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/integrals/edge_pieces.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
using dealii::Point;
using Crossing = Discontinuities::Crossing;

namespace
{
/** The part of an edge that is too short to be cut again. */
constexpr double shortest_edge_piece = 1e-14;

/** The distance of an argument from its level, over the size of what it is a
 * difference of, that may be rounding. */
constexpr double rounding_of_edge = 1e-13;

/** The largest number of pieces; the rest counts as not smooth. */
constexpr unsigned int n_max_edge_pieces = 10000;

/** The jump to cut at: one whose argument has one root at most, if any. */
const Crossing &easiest(const std::vector<Crossing> &crossings)
{
  for (const Crossing &crossing : crossings)
    if (excludes_zero(crossing.distance.slope[0]))
      return crossing;
  return crossings.front();
}

struct EdgeCutter
{
  const Point<2> a, b;
  const Discontinuities &jumps;
  std::vector<EdgePiece> open = {}, done = {};

  std::vector<EdgePiece> cut(const Discontinuities::Limits &limits)
  {
    open.push_back({0., 1., true, limits});
    while (!open.empty())
    {
      const EdgePiece part = std::move(open.back());
      open.pop_back();
      cut(part);
    }
    return std::move(done);
  }

  Point<2> at(const double t) const { return a + t * (b - a); }

  void cut(const EdgePiece &part)
  {
    const double length = part.end - part.begin;
    const double middle = 0.5 * (part.begin + part.end);
    const Patch patch = {at(middle), {{0.5 * length * (b - a), {}}}};
    const auto crossings = jumps.crossings(patch, part.limits);
    if (crossings.empty())
      return done.push_back(part);
    const Crossing &crossing = easiest(crossings);
    if (length < shortest_edge_piece ||
        open.size() + done.size() > n_max_edge_pieces)
      done.push_back({part.begin, part.end, false, part.limits});
    else if (std::isfinite(crossing.scale) &&
             magnitude(crossing.distance.value) <=
                 rounding_of_edge * crossing.scale)
      choose_side(part, crossing);
    else if (excludes_zero(crossing.distance.slope[0]))
      cut_at_root(part, crossing);
    else
    {
      open.push_back({part.begin, middle, part.is_smooth, part.limits});
      open.push_back({middle, part.end, part.is_smooth, part.limits});
    }
  }

  /** Take the side of a jump that runs along @p part. */
  void choose_side(const EdgePiece &part, const Crossing &crossing)
  {
    const Point<2> middle = at(0.5 * (part.begin + part.end));
    const bool is_below = jumps.distance(crossing, middle) < 0.;
    open.push_back(
        {part.begin, part.end,
         part.is_smooth && !jumps.is_step(crossing, middle, part.limits),
         Discontinuities::on_side(crossing, is_below, part.limits)});
  }

  /** Cut @p part at the root of a jump's argument, monotonic along it. */
  void cut_at_root(const EdgePiece &part, const Crossing &crossing)
  {
    const Point<2> begin = at(part.begin), end = at(part.end);
    const double first = jumps.distance(crossing, begin);
    const double last = jumps.distance(crossing, end);
    const auto add = [&](const double from, const double to, const bool below) {
      if (from < to)
        open.push_back(
            {from, to, part.is_smooth,
             Discontinuities::on_side(crossing, below, part.limits)});
    };
    if (!(first * last < 0.)) // one of them may be zero
      return add(part.begin, part.end, first + last < 0.);
    const double root =
        part.begin + root_between(begin, end, first, last, jumps, crossing) *
                         (part.end - part.begin);
    add(part.begin, root, first < 0.);
    add(root, part.end, last < 0.);
  }
};
} // namespace

std::vector<EdgePiece> edge_pieces(const Point<2> &a,
                                   const Point<2> &b,
                                   const Discontinuities &jumps,
                                   const Discontinuities::Limits &limits)
{
  return EdgeCutter{a, b, jumps}.cut(limits);
}

double root_between(const Point<2> &a,
                    const Point<2> &b,
                    const double distance_a,
                    const double distance_b,
                    const Discontinuities &jumps,
                    const Crossing &crossing)
{
  std::uintmax_t n_evaluations = 200;
  const auto root = boost::math::tools::toms748_solve(
      [&](const double t) { return jumps.distance(crossing, a + t * (b - a)); },
      0., 1., distance_a, distance_b,
      [](const double lower, const double upper) {
        return upper - lower <=
               4. * std::numeric_limits<double>::epsilon() * upper;
      },
      n_evaluations);
  return 0.5 * (root.first + root.second);
}
} // namespace Voussoir
