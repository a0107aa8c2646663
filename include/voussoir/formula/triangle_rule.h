// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_triangle_rule_h
#define voussoir_formula_triangle_rule_h

#include <voussoir/formula/linear_fit.h>

namespace Voussoir
{
/**
 * A quadrature rule on triangles of seven points and degree five, with a
 * measure of how uneven a function is in these points.
 *
 * Of functions that are smooth the measure falls like the square of the size of
 * the triangle, and the error of the rule like the sixth power. For plane waves
 * and exponentials in all directions the error is at most 0.11 times its cube;
 * null rules of higher degree are blind in some directions.
 */
struct TriangleRule
{
  TriangleRule();

  /** The number of points, seven. */
  static constexpr unsigned int n_points = 7;

  /** In the triangle (0, 0), (1, 0), (0, 1), of area one half. */
  std::vector<dealii::Point<2>> points;
  /** They add up to one. */
  std::vector<double> weights;
  /** Of values in them. */
  LinearFit<n_points> fit;
};
} // namespace Voussoir

#endif
