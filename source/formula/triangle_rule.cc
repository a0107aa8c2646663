// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/triangle_rule.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** deal.II's rule of this number has seven points and degree five. */
constexpr unsigned int rule_number = 3;

/** The difference of numbers that are the same but for rounding. */
constexpr double rounding = 1e-8;
} // namespace

TriangleRule::TriangleRule()
{
  const dealii::QGaussSimplex<2> rule(rule_number);
  points = rule.get_points();
  for (const double weight : rule.get_weights())
    weights.push_back(2. * weight);

  // The points are the centroid and two orbits of three, each with its own sum
  // of squares of the barycentric coordinates. An even rule that is zero for
  // constants and for that sum is zero for all polynomials of degree two.
  std::vector<double> square;
  for (const dealii::Point<2> &x : points)
    square.push_back(x * x + (1. - x[0] - x[1]) * (1. - x[0] - x[1]));
  const double least = 1. / 3.; // at the centroid
  const double most = *std::max_element(square.begin(), square.end());
  const auto is = [](const double a, const double b) {
    return std::abs(a - b) < rounding;
  };
  double between = 0.;
  for (const double s : square)
    if (!is(s, least) && !is(s, most))
      between = s;
  const double of_between = -(most - least) / (between - least);
  double size = 0.;
  for (const double s : square)
  {
    null_weights.push_back(is(s, most)    ? 1.
                           : is(s, least) ? -3. - 3. * of_between
                                          : of_between);
    size += std::abs(null_weights.back());
  }
  for (double &weight : null_weights)
    weight /= size;
}
} // namespace Voussoir
