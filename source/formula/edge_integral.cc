// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/edge_integral.h>
#include <voussoir/formula/edge_pieces.h>
#include <voussoir/formula/gauss_kronrod.h>

#include <cmath>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** What integrate() is to reach, relative to the mean size of the function. */
constexpr double tolerance = 1e-13;

/** In each part. */
constexpr unsigned int n_points = 15;
} // namespace

EdgeIntegral edge_integral(const Point<2> &a,
                           const Point<2> &b,
                           const std::function<double(const Point<2> &)> &f,
                           const Jumps &jumps)
{
  EdgeIntegral result = {0., 0., 0., 0., 0.};
  // Of the function, and of it times the distance from the middle.
  const auto integrand = [&](const double t) {
    const double value = f(a + t * (b - a));
    Integrals<2> sum;
    sum.values = {{value, value * (t - 0.5), result.size}};
    return sum;
  };
  const auto add = [&](const auto &integral) {
    result.mean += integral.value.values[0];
    result.moment += integral.value.values[1];
    result.error += integral.error;
  };
  if (jumps.empty())
  {
    const auto once = integrate_once<n_points>(integrand, 0., 1.);
    result.size = once.size;
    add(once.error <= tolerance * once.size
            ? once
            : integrate<n_points>(integrand, 0., 1., tolerance));
    return result;
  }

  const auto pieces = edge_pieces(a, b, jumps, jumps.no_limits());
  double size = 0.;
  for (const EdgePiece &piece : pieces)
    size += integrate_once<n_points>(integrand, piece.begin, piece.end).size;
  result.size = size;
  for (const EdgePiece &piece : pieces)
  {
    if (piece.is_smooth)
    {
      add(integrate<n_points>(integrand, piece.begin, piece.end, tolerance));
      continue;
    }
    const double length = piece.end - piece.begin;
    const double t = 0.5 * (piece.begin + piece.end);
    const auto middle = integrand(t);
    result.mean += length * middle.values[0];
    result.moment += length * middle.values[1];
    result.uncertain += length;
  }
  return result;
}
} // namespace Voussoir
