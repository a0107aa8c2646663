// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/integrals/edge_pieces.h>
#include <voussoir/formula/integrals/strip_integral.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** The tolerances of integrate() along one coordinate, and along the other. */
constexpr double inner_tolerance = 1e-13;
constexpr double outer_tolerance = 1e-12;

/** The points of the rule in each part along a coordinate. */
constexpr unsigned int n_strip_points = 21;

/** The width of a strip, over that of its piece, that is rounding. */
constexpr double narrowest_strip = 1e-14;

struct Strips
{
  const AreaPiece &piece;
  const Discontinuities &jumps;
  const std::function<AreaSums(const Point<2> &)> &f;
  const std::function<bool()> &is_exhausted;

  Integral<AreaSums> integral() const
  {
    Integral<AreaSums> sum = {0., 0., 0.};
    const std::vector<double> cuts = strips();
    for (unsigned int k = 0; k + 1 < cuts.size(); ++k)
    {
      const auto strip = integrate<n_strip_points>(
          [&](const double s) { return across(s); }, cuts[k], cuts[k + 1],
          reachable(outer_tolerance));
      sum.value += strip.value;
      sum.error += strip.error;
      sum.size += strip.size;
    }
    return sum;
  }

  double reachable(const double tolerance) const
  {
    return is_exhausted() ? std::numeric_limits<double>::infinity() : tolerance;
  }

  /**
   * The coordinates at which corners are, or the curve leaves the piece;
   * ascending.
   */
  std::vector<double> strips() const
  {
    const unsigned int s = 1 - piece.along;
    std::vector<double> all;
    for (unsigned int i = 0; i < piece.corners.size(); ++i)
    {
      const Point<2> &a = piece.corners[i];
      const Point<2> &b = piece.corners[(i + 1) % piece.corners.size()];
      all.push_back(a[s]);
      if (piece.crossing)
        for (const EdgePiece &part : edge_pieces(a, b, jumps, piece.limits))
          all.push_back(a[s] + part.end * (b[s] - a[s]));
    }
    std::sort(all.begin(), all.end());
    const double narrow = narrowest_strip * (all.back() - all.front());
    std::vector<double> cuts;
    for (const double cut : all)
      if (cuts.empty() || cut > cuts.back() + narrow)
        cuts.push_back(cut);
    return cuts;
  }

  /** The integral along the line at @p s through the piece. */
  AreaSums across(const double s) const
  {
    const std::pair<Point<2>, Point<2>> both = ends(s);
    const Point<2> &a = both.first, &b = both.second;
    const double length = b[piece.along] - a[piece.along];
    const auto between = [&](const double begin, const double end) {
      return length * integrate<n_strip_points>(
                          [&](const double t) { return f(a + t * (b - a)); },
                          begin, end, reachable(inner_tolerance))
                          .value;
    };
    if (!(length > 0.))
      return 0.;
    if (piece.crossing)
    {
      const double first = jumps.distance(*piece.crossing, a);
      const double last = jumps.distance(*piece.crossing, b);
      if (first * last < 0.)
      {
        const double root =
            root_between(a, b, first, last, jumps, *piece.crossing);
        return between(0., root) + between(root, 1.);
      }
    }
    return between(0., 1.);
  }

  /** The lower and the upper end of the line at @p s through the piece. */
  std::pair<Point<2>, Point<2>> ends(const double s) const
  {
    const unsigned int along = piece.along, other = 1 - piece.along;
    Point<2> lower, upper;
    bool is_first = true;
    for (unsigned int i = 0; i < piece.corners.size(); ++i)
    {
      const Point<2> &a = piece.corners[i];
      const Point<2> &b = piece.corners[(i + 1) % piece.corners.size()];
      if ((s - a[other]) * (s - b[other]) > 0. || a[other] == b[other])
        continue;
      Point<2> p;
      p[other] = s;
      p[along] = a[along] +
                 (s - a[other]) / (b[other] - a[other]) * (b[along] - a[along]);
      if (is_first || p[along] < lower[along])
        lower = p;
      if (is_first || p[along] > upper[along])
        upper = p;
      is_first = false;
    }
    return {lower, upper};
  }
};
} // namespace

Integral<AreaSums>
strip_integral(const AreaPiece &piece,
               const Discontinuities &jumps,
               const std::function<AreaSums(const Point<2> &)> &f,
               const std::function<bool()> &is_exhausted)
{
  return Strips{piece, jumps, f, is_exhausted}.integral();
}
} // namespace Voussoir
