// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/integrals/edge_integral.h>
#include <voussoir/formula/integrals/edge_pieces.h>
#include <voussoir/formula/integrals/gauss_kronrod.h>
#include <voussoir/formula/integrals/linear_fit.h>
#include <voussoir/formula/integrals/samples.h>

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cmath>

namespace Voussoir
{
using dealii::Point;

namespace
{
using EdgeFunction = std::function<double(const Point<2> &)>;

/** The tolerance of integrate(), relative to the mean size of the function. */
constexpr double tolerance = 1e-13;

/** The points of the rule in each part. */
constexpr unsigned int n_edge_points = 15;

/** The length of a piece in which a hidden peak would not count. */
constexpr double shortest_half = 1e-12;
/** The error of a first look at a piece, over the size of the function there,
 * with which not even the estimate can be trusted. */
constexpr double roughness_of_edge = 1e-2;
/** The largest number of pieces that are made for peaks. */
constexpr unsigned int n_max_halves = 200;

/**
 * LinearFit::unevenness() in the points of Gauss' rule of degree seven, over
 * the mean size of the function, with which that quick rule is good: for waves,
 * exponentials and powers its errors, also of the moment, are then at most
 * 2e-13 of that size.
 */
constexpr double smallest_edge_unevenness = 1e-4;

struct EdgeIntegrator
{
  using Sums = Integrals<2>;

  const Point<2> a, b;
  const EdgeFunction &f;
  const Discontinuities &jumps;
  Samples samples = {};
  double mean_size = 0.;
  EdgeIntegral result = {0., 0., 0., 0., 0.};

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
      Integral<Sums> found;
      while (!look_at(pieces[k], found) && pieces.size() < n_max_halves)
      {
        const double middle = 0.5 * (pieces[k].begin + pieces[k].end);
        pieces.push_back(pieces[k]);
        pieces[k].end = pieces.back().begin = middle;
      }
      first.push_back(found);
      size += found.size;
    }
    result.size = mean_size = size;
    for (std::size_t k = 0; k < pieces.size(); ++k)
      add(pieces[k], first[k]);
    return result;
  }

  /** The function and its moment; the constant is the mean size. */
  Sums at(const double t)
  {
    const double value = f(a + t * (b - a));
    samples.add(value);
    Sums sums;
    sums.values = {{value, value * (t - 0.5), mean_size}};
    return sums;
  }

  /** Find the integral over a piece, and whether it need not be halved. */
  bool look_at(const EdgePiece &piece, Integral<Sums> &found)
  {
    samples = Samples();
    if (look_quickly(piece, found) && !may_hide_a_peak(piece))
      return true;
    samples = Samples();
    found = integrate_once<n_edge_points>(
        [this](const double t) { return at(t); }, piece.begin, piece.end);
    return found.error <= roughness_of_edge * found.size &&
           !may_hide_a_peak(piece);
  }

  /** True if the quick rule is good. */
  bool look_quickly(const EdgePiece &piece, Integral<Sums> &found)
  {
    static const FittedRule<1, 4> rule{dealii::QGauss<1>(4)};
    const double length = piece.end - piece.begin;
    std::array<double, rule.n_points> values;
    found = {0., 0., 0.};
    for (unsigned int q = 0; q < rule.n_points; ++q)
    {
      const double weight = rule.weights[q] * length;
      const Sums there = at(piece.begin + rule.points[q][0] * length);
      values[q] = there.values[0];
      found.value += weight * there;
      found.size += weight * std::abs(values[q]);
    }
    return rule.fit.unevenness(values) * length <=
           smallest_edge_unevenness * found.size;
  }

  /** True if the bounds allow a peak that the last samples did not show. */
  bool may_hide_a_peak(const EdgePiece &piece) const
  {
    const double length = piece.end - piece.begin;
    if (!jumps.has_formulas() || !piece.is_smooth || length < shortest_half)
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
      found = integrate<n_edge_points>([this](const double t) { return at(t); },
                                       piece.begin, piece.end, tolerance);
    result.mean += found.value.values[0];
    result.moment += found.value.values[1];
    result.error += found.error;
  }
};
} // namespace

EdgeIntegral edge_integral(const Point<2> &a,
                           const Point<2> &b,
                           const std::function<double(const Point<2> &)> &f,
                           const Discontinuities &jumps)
{
  return EdgeIntegrator{a, b, f, jumps}.integral();
}
} // namespace Voussoir
