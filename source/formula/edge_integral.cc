// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/edge_integral.h>
#include <voussoir/formula/edge_pieces.h>
#include <voussoir/formula/gauss_kronrod.h>
#include <voussoir/formula/samples.h>

#include <cmath>

namespace Voussoir
{
using dealii::Point;

namespace
{
using Function = std::function<double(const Point<2> &)>;

/** What integrate() is to reach, relative to the mean size of the function. */
constexpr double tolerance = 1e-13;

/** In each part. */
constexpr unsigned int n_points = 15;

/** The length of a piece in which a hidden peak would not count. */
constexpr double shortest_piece = 1e-12;
/** The error of a first look at a piece, over the size of the function there,
 * with which not even the estimate can be trusted. */
constexpr double roughness = 1e-2;
/** More pieces are not made for the sake of peaks. */
constexpr unsigned int n_max_pieces = 200;

class Integrator
{
public:
  Integrator(const Point<2> &a,
             const Point<2> &b,
             const Function &f,
             const Jumps &jumps)
      : a(a), b(b), f(f), jumps(jumps)
  {
  }

  EdgeIntegral integral()
  {
    auto pieces =
        jumps.empty()
            ? std::vector<EdgePiece>{{0., 1., true, jumps.no_limits()}}
            : edge_pieces(a, b, jumps, jumps.no_limits());
    std::vector<Integral<Sums>> first;
    double size = 0.;
    for (std::size_t k = 0; k < pieces.size(); ++k)
    {
      // Halves may follow at the end of the list.
      Integral<Sums> found = look_at(pieces[k]);
      while (
          pieces.size() < n_max_pieces &&
          (found.error > roughness * found.size || may_hide_a_peak(pieces[k])))
      {
        const double middle = 0.5 * (pieces[k].begin + pieces[k].end);
        pieces.push_back(pieces[k]);
        pieces[k].end = pieces.back().begin = middle;
        found = look_at(pieces[k]);
      }
      first.push_back(found);
      size += found.size;
    }
    result.size = mean_size = size;
    for (std::size_t k = 0; k < pieces.size(); ++k)
      add(pieces[k], first[k]);
    return result;
  }

private:
  using Sums = Integrals<2>;

  /** The function and its moment; the constant is the mean size. */
  Sums at(const double t)
  {
    const double value = f(a + t * (b - a));
    samples.add(value);
    Sums sums;
    sums.values = {{value, value * (t - 0.5), mean_size}};
    return sums;
  }

  Integral<Sums> look_at(const EdgePiece &piece)
  {
    samples = Samples();
    return integrate_once<n_points>([this](const double t) { return at(t); },
                                    piece.begin, piece.end);
  }

  /** By the samples of the last look. */
  bool may_hide_a_peak(const EdgePiece &piece) const
  {
    const double length = piece.end - piece.begin;
    if (!jumps.has_formulas() || !piece.is_smooth || length < shortest_piece)
      return false;
    const Patch patch = {a + 0.5 * (piece.begin + piece.end) * (b - a),
                         {{0.5 * length * (b - a), {}}}};
    return !samples.cover(jumps.bounds_in(patch, piece.limits).front(), 0.);
  }

  void add(const EdgePiece &piece, Integral<Sums> found)
  {
    const double length = piece.end - piece.begin;
    if (!piece.is_smooth)
    {
      found = {length * at(0.5 * (piece.begin + piece.end)), 0., 0.};
      result.uncertain += length;
    }
    else if (found.error > tolerance * mean_size * length)
      found = integrate<n_points>([this](const double t) { return at(t); },
                                  piece.begin, piece.end, tolerance);
    result.mean += found.value.values[0];
    result.moment += found.value.values[1];
    result.error += found.error;
  }

  const Point<2> a, b;
  const Function &f;
  const Jumps &jumps;
  Samples samples;
  double mean_size = 0.;
  EdgeIntegral result = {0., 0., 0., 0., 0.};
};
} // namespace

EdgeIntegral edge_integral(const Point<2> &a,
                           const Point<2> &b,
                           const std::function<double(const Point<2> &)> &f,
                           const Jumps &jumps)
{
  return Integrator(a, b, f, jumps).integral();
}
} // namespace Voussoir
