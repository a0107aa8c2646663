// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/local_system.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
/** The size up to which elimination without a sparse ordering is faster. */
constexpr unsigned int largest_small_system = 80;

LocalSystem::LocalSystem(const dealii::DynamicSparsityPattern &entries)
    : is_small(entries.n_rows() <= largest_small_system)
{
  if (is_small)
    dense.reinit(entries.n_rows(), entries.n_rows());
  else
  {
    pattern.copy_from(entries);
    sparse.reinit(pattern);
  }
}

/**
 * Gaussian elimination with partial pivoting, which passes over the many zeros
 * of these matrices. For 18 unknowns, those of a hexagon, calling LAPACK takes
 * longer than the work.
 */
bool LocalSystem::eliminate(dealii::Vector<double> &x)
{
  const unsigned int n = x.size();
  for (unsigned int k = 0; k < n; ++k)
  {
    unsigned int pivot = k;
    for (unsigned int i = k + 1; i < n; ++i)
      if (std::abs(dense(i, k)) > std::abs(dense(pivot, k)))
        pivot = i;
    double *const row = &dense(k, 0);
    if (pivot != k)
    {
      std::swap_ranges(row + k, row + n, &dense(pivot, k));
      std::swap(x[k], x[pivot]);
    }
    if (row[k] == 0.)
      return false;
    for (unsigned int i = k + 1; i < n; ++i)
    {
      double *const other = &dense(i, 0);
      if (other[k] == 0.)
        continue;
      const double factor = other[k] / row[k];
      for (unsigned int j = k + 1; j < n; ++j)
        other[j] -= factor * row[j];
      x[i] -= factor * x[k];
    }
  }
  for (unsigned int k = n; k-- > 0;)
  {
    for (unsigned int j = k + 1; j < n; ++j)
      x[k] -= dense(k, j) * x[j];
    x[k] /= dense(k, k);
  }
  return true;
}

bool LocalSystem::solve(dealii::Vector<double> &x)
try
{
  if (is_small && !eliminate(x))
    return false;
  if (!is_small)
  {
    dealii::SparseDirectUMFPACK factor;
    factor.factorize(sparse);
    factor.solve(x);
  }
  return std::all_of(x.begin(), x.end(),
                     [](const double value) { return std::isfinite(value); });
}
catch (const dealii::SparseDirectUMFPACK::ExcUMFPACKError &)
{
  return false;
}
} // namespace Voussoir
