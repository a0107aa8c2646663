// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/edge_mean.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace Voussoir
{
namespace
{
/** Gauss points in each part; the rule is exact up to degree five. */
constexpr unsigned int n_gauss_points = 3;

/** The error, relative to the largest value met, to be reached. */
constexpr double aim = 1e-14;
/** The same to be content with where rounding or the number of parts ends it.
 */
constexpr double limit = 1e-6;
/** Some fifty parts locate one jump to rounding. */
constexpr unsigned int n_max_parts = 500;

/** A part of the edge, in the coordinate from 0 to 1 along it. */
struct Part
{
  double begin, end;
  /** Integrals over its halves. */
  std::pair<double, double> halves;
  /** How far their sum is from the integral by the rule on the whole part. */
  double error;

  bool operator<(const Part &other) const
  {
    return error < other.error;
  }
};
} // namespace

double edge_mean(const dealii::Point<2> &a,
                 const dealii::Point<2> &b,
                 const std::function<double(const dealii::Point<2> &)> &f,
                 const std::string &parameter)
{
  static const dealii::QGauss<1> rule(n_gauss_points);
  double largest = 0.;
  const auto integral = [&](const double begin, const double end) {
    double sum = 0.;
    for (unsigned int q = 0; q < rule.size(); ++q)
    {
      const double t = begin + rule.point(q)[0] * (end - begin);
      const double value = f(a + t * (b - a));
      largest = std::max(largest, std::abs(value));
      sum += rule.weight(q) * (end - begin) * value;
    }
    return sum;
  };
  const auto make_part = [&](const double begin, const double end,
                             const double whole) {
    const double middle = 0.5 * (begin + end);
    Part part = {
        begin, end, {integral(begin, middle), integral(middle, end)}, 0.};
    part.error = std::abs(part.halves.first + part.halves.second - whole);
    return part;
  };

  std::priority_queue<Part> parts;
  parts.push(make_part(0., 1., integral(0., 1.)));
  double error = parts.top().error;
  while (error > aim * largest && parts.size() < n_max_parts)
  {
    const Part worst = parts.top();
    parts.pop();
    const double middle = 0.5 * (worst.begin + worst.end);
    error -= worst.error;
    for (const Part &half : {make_part(worst.begin, middle, worst.halves.first),
                             make_part(middle, worst.end, worst.halves.second)})
    {
      error += half.error;
      parts.push(half);
    }
  }
  if (error > limit * largest)
    throw InputError("The expression of '" + parameter +
                     "' varies too fast along the edge from " +
                     text_of_point(a) + " to " + text_of_point(b) +
                     " to find its mean; make it smoother.");

  double mean = 0.;
  for (; !parts.empty(); parts.pop())
    mean += parts.top().halves.first + parts.top().halves.second;
  return mean;
}
} // namespace Voussoir
