// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear_method.h>

namespace Voussoir
{
std::vector<double> to_columns(const std::vector<double> &u,
                               const unsigned int n_components)
{
  const unsigned int n_columns = 2 / n_components;
  const std::size_t n_rows = u.size() / n_columns;
  std::vector<double> columns(u.size());
  for (std::size_t k = 0; k < u.size(); ++k)
    columns[k % n_columns * n_rows + k / n_columns] = u[k];
  return columns;
}

std::vector<double> from_columns(const std::vector<double> &columns,
                                 const unsigned int n_components)
{
  const unsigned int n_columns = 2 / n_components;
  const std::size_t n_rows = columns.size() / n_columns;
  std::vector<double> u(columns.size());
  for (std::size_t k = 0; k < u.size(); ++k)
    u[k] = columns[k % n_columns * n_rows + k / n_columns];
  return u;
}
} // namespace Voussoir
