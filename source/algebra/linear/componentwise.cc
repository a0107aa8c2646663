// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/componentwise.h>

#include <deal.II/base/exceptions.h>

#include <utility>

namespace Voussoir
{

Componentwise::Componentwise(std::unique_ptr<LinearMethod> one,
                             const unsigned int n_components)
    : one(std::move(one)), n_components(n_components)
{}

bool Componentwise::prepare(const std::vector<double> &coefficients,
                            const double shift)
{
  return one->prepare(coefficients, shift);
}

std::vector<double> Componentwise::solve(const std::vector<double> &r,
                                         const unsigned int n_columns)
{
  AssertDimension(n_columns, 1);
  (void)n_columns;
  const std::size_t n = r.size() / n_components;
  const auto place = [&](const std::size_t k) {
    return k % n_components * n + k / n_components;
  };
  std::vector<double> columns(r.size());
  for (std::size_t k = 0; k < r.size(); ++k)
    columns[place(k)] = r[k];
  columns = one->solve(columns, n_components);
  std::vector<double> u(r.size());
  for (std::size_t k = 0; k < r.size(); ++k)
    u[k] = columns[place(k)];
  return u;
}

bool Componentwise::is_direct() const
{
  return one->is_direct();
}

} // namespace Voussoir
