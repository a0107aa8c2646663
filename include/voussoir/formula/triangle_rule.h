// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_triangle_rule_h
#define voussoir_formula_triangle_rule_h

#include <deal.II/base/point.h>

#include <vector>

namespace Voussoir
{
/**
 * A quadrature rule on triangles, and a null rule: other weights in the same
 * points that add up to zero, for polynomials of degree two as well. What it
 * finds falls like the third power of the size of the triangle, and the error
 * of the rule, of degree five, like the sixth (Lyness, *Numerische Mathematik*
 * 8 (1966), 321, has null rules).
 */
class TriangleRule
{
public:
  TriangleRule();

  /** The number of points, seven. */
  unsigned int size() const
  {
    return points.size();
  }

  /** In the triangle (0, 0), (1, 0), (0, 1), of area one half. */
  std::vector<dealii::Point<2>> points;
  /** They add up to one. */
  std::vector<double> weights;
  /** Their sizes add up to one. */
  std::vector<double> null_weights;
};
} // namespace Voussoir

#endif
