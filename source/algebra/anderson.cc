// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/anderson.h>
#include <voussoir/algebra/vectors.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cstddef>

namespace Voussoir
{
namespace
{
/** Differences this much smaller than the largest are rounding. */
constexpr double rounding = 1e-10;

std::vector<double> difference(const std::vector<double> &a,
                               const std::vector<double> &b)
{
  std::vector<double> result = a;
  add(result, -1., b);
  return result;
}
} // namespace

std::vector<double> Anderson::next(const std::vector<double> &x,
                                   const std::vector<double> &g)
{
  earlier.push_back({g, difference(g, x)});
  if (earlier.size() > depth + 1)
    earlier.pop_front();
  const unsigned int n = earlier.size() - 1;
  if (n == 0)
    return g;

  // The combination of the last steps with the least residual.
  std::vector<std::vector<double>> changes;
  for (unsigned int k = 0; k < n; ++k)
    changes.push_back(difference(earlier[k + 1].residual, earlier[k].residual));
  dealii::LAPACKFullMatrix<double> products(n, n);
  dealii::Vector<double> right(n), weights(n);
  for (unsigned int i = 0; i < n; ++i)
  {
    for (unsigned int j = 0; j < n; ++j)
      products(i, j) = dot(changes[i], changes[j]);
    right[i] = dot(changes[i], earlier.back().residual);
  }
  products.compute_inverse_svd(rounding * rounding);
  products.vmult(weights, right);
  std::vector<double> result = g;
  for (unsigned int k = 0; k < n; ++k)
  {
    add(result, -weights[k], earlier[k + 1].g);
    add(result, weights[k], earlier[k].g);
  }
  return result;
}
} // namespace Voussoir
