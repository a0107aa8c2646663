// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_integrals_linear_fit_h
#define voussoir_formula_integrals_linear_fit_h

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace Voussoir
{
/** Functions by their values in @p n points, and the linear ones among them. */
template <unsigned int n>
class LinearFit
{
public:
  /** Values of a function in the points. */
  using Values = std::array<double, n>;

  /** For @p n points. */
  template <int dim>
  explicit LinearFit(const std::vector<dealii::Point<dim>> &points)
  {
    for (unsigned int i = 0; i <= dim; ++i)
    {
      Values function;
      for (unsigned int q = 0; q < n; ++q)
        function[q] = i == 0 ? 1. : points[q][i - 1];
      take_out(function);
      const double norm = std::sqrt(product(function, function));
      for (double &value : function)
        value /= norm;
      basis.push_back(function);
    }
  }

  /** The root mean square of what is left of @p values by the linear function
   * that fits them best; in their unit. */
  double unevenness(Values values) const
  {
    take_out(values);
    return std::sqrt(product(values, values) / n);
  }

private:
  static double product(const Values &a, const Values &b)
  {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
  }

  /** Subtract the parts along the basis so far. */
  void take_out(Values &values) const
  {
    for (const Values &function : basis)
    {
      const double part = product(values, function);
      for (unsigned int q = 0; q < n; ++q)
        values[q] -= part * function[q];
    }
  }

  /** An orthonormal basis of the linear functions. */
  std::vector<Values> basis;
};

/** A quadrature rule of @p n points with the linear functions in these. */
template <int dim, unsigned int n>
struct FittedRule
{
  static constexpr unsigned int n_points = n; /**< that it has */
  std::vector<dealii::Point<dim>> points;     /**< from 0 to 1 */
  std::vector<double> weights;                /**< of the points */
  LinearFit<n> fit;                           /**< in the points */

  /** From deal.II's. */
  explicit FittedRule(const dealii::Quadrature<dim> &rule)
      : points(rule.get_points()), weights(rule.get_weights()), fit(points)
  {
    AssertDimension(points.size(), n);
  }
};
} // namespace Voussoir

#endif
