// SPDX-License-Identifier: LGPL-2.1-or-later
/* What SparseFactor does with its factors. */
#include <voussoir/algebra/linear/cholmod_failure.h>
#include <voussoir/algebra/linear/sparse_factor.h>

#include <algorithm>

namespace Voussoir
{
std::vector<double> SparseFactor::solve(const int system,
                                        const std::vector<double> &r,
                                        const unsigned int n_columns) const
{
  AssertDimension(r.size(), std::size_t(n()) * n_columns);
  cholmod_dense right = {};
  right.nrow = right.d = n();
  right.ncol = n_columns;
  right.nzmax = r.size();
  right.x = const_cast<double *>(r.data()); // it is read only
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  // CHOLMOD writes to what is common, which other threads need as well.
  cholmod_common own;
  cholmod_start(&own);
  own.print = 0;
  cholmod_dense *values = cholmod_solve(system, factor, &right, &own);
  const bool has_failed = values == nullptr;
  std::vector<double> result;
  if (!has_failed)
  {
    const double *x = static_cast<const double *>(values->x);
    result.assign(x, x + r.size());
    cholmod_free_dense(&values, &own);
  }
  cholmod_finish(&own);
  if (has_failed)
    throw_failure(own);
  return result;
}

std::vector<double> SparseFactor::reordered(const std::vector<double> &values,
                                            const unsigned int n_columns,
                                            const bool to_elimination) const
{
  std::vector<double> result(values.size());
  const unsigned int n = blocks.n();
  for (std::size_t c = 0, k = 0; c < n_columns; ++c)
    for (unsigned int b = 0; b < n_bodies; ++b)
      for (unsigned int i = 0; i < n; ++i, ++k)
      {
        const std::size_t unknown =
            (c * n_bodies + static_cast<std::size_t>(order[b])) * n + i;
        if (to_elimination)
          result[k] = values[unknown];
        else
          result[unknown] = values[k];
      }
  return result;
}

std::vector<double> SparseFactor::in_order(const std::vector<double> &r,
                                           const unsigned int n_columns) const
{
  return reordered(r, n_columns, true);
}

std::vector<double> SparseFactor::by_bodies(const std::vector<double> &y,
                                            const unsigned int n_columns) const
{
  return reordered(y, n_columns, false);
}

std::vector<double> SparseFactor::solve(const std::vector<double> &r,
                                        const unsigned int n_columns) const
{
  return by_bodies(solve(CHOLMOD_A, in_order(r, n_columns), n_columns),
                   n_columns);
}

std::vector<double> SparseFactor::forward(const std::vector<double> &r,
                                          const unsigned int n_columns) const
{
  return solve(CHOLMOD_L, in_order(r, n_columns), n_columns);
}

std::vector<double> SparseFactor::backward(const std::vector<double> &y,
                                           const unsigned int n_columns) const
{
  return by_bodies(solve(CHOLMOD_Lt, y, n_columns), n_columns);
}

std::vector<unsigned int> SparseFactor::last_unknowns() const
{
  std::vector<unsigned int> result;
  for (std::size_t k = n_bodies - last.size(); k < n_bodies; ++k)
    for (unsigned int i = 0; i < blocks.n(); ++i)
      result.push_back(blocks.n() * order[k] + i);
  return result;
}

const dealii::FullMatrix<double> &SparseFactor::last_block() const
{
  return block;
}

std::vector<double> SparseFactor::added() const
{
  std::vector<double> result;
  for (const unsigned int unknown : last_unknowns())
    result.push_back(addition[std::lower_bound(last.begin(), last.end(),
                                               unknown / blocks.n()) -
                              last.begin()]);
  return result;
}
} // namespace Voussoir
