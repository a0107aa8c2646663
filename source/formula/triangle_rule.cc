// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/triangle_rule.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <numeric>

namespace Voussoir
{
namespace
{
/** deal.II's rule of this number has seven points and degree five. */
constexpr unsigned int rule_number = 3;

using Values = TriangleRule::Values;

double product(const Values &a, const Values &b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}

/** Subtract from @p a its part along the unit vector @p b. */
void take_out(Values &a, const Values &b)
{
  const double part = product(a, b);
  for (unsigned int q = 0; q < a.size(); ++q)
    a[q] -= part * b[q];
}
} // namespace

TriangleRule::TriangleRule()
{
  const dealii::QGaussSimplex<2> rule(rule_number);
  AssertDimension(rule.size(), n_points);
  points = rule.get_points();
  for (const double weight : rule.get_weights())
    weights.push_back(2. * weight);

  for (unsigned int q = 0; q < n_points; ++q)
  {
    linear[0][q] = 1.;
    linear[1][q] = points[q][0];
    linear[2][q] = points[q][1];
  }
  for (unsigned int i = 0; i < linear.size(); ++i)
  {
    for (unsigned int j = 0; j < i; ++j)
      take_out(linear[i], linear[j]);
    const double norm = std::sqrt(product(linear[i], linear[i]));
    for (double &value : linear[i])
      value /= norm;
  }
}

double TriangleRule::unevenness(const Values &values) const
{
  Values rest = values;
  for (const Values &function : linear)
    take_out(rest, function);
  return std::sqrt(product(rest, rest) / n_points);
}
} // namespace Voussoir
