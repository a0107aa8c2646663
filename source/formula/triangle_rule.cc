// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/triangle_rule.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

namespace Voussoir
{
namespace
{
/** deal.II's rule of this number has seven points and degree five. */
constexpr unsigned int rule_number = 3;
} // namespace

TriangleRule::TriangleRule()
    : points(dealii::QGaussSimplex<2>(rule_number).get_points()),
      weights(dealii::QGaussSimplex<2>(rule_number).get_weights()), fit(points)
{
  AssertDimension(points.size(), n_points);
  for (double &weight : weights)
    weight *= 2.;
}
} // namespace Voussoir
