// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/componentwise.h>

#include <deal.II/base/exceptions.h>

#include <numeric>
#include <utility>

namespace Voussoir
{

Componentwise::Componentwise(std::unique_ptr<LinearMethod> one)
    : one(std::move(one))
{}

bool Componentwise::serves(const Structure &structure,
                           const std::vector<double> &coefficients)
{
  const unsigned int n_contacts = structure.n_contacts();
  bool same = true;
  for (auto a = coefficients.begin(); a != coefficients.end() && same;
       a += n_contacts + 1)
    same = std::accumulate(a, a + n_contacts, 0.) == a[n_contacts];
  return structure.processes().all(same);
}

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
  const std::size_t n = r.size() / 2;
  std::vector<double> columns(r.size());
  for (std::size_t k = 0; k < r.size(); ++k)
    columns[k % 2 * n + k / 2] = r[k];
  columns = one->solve(columns, 2);
  std::vector<double> u(r.size());
  for (std::size_t k = 0; k < r.size(); ++k)
    u[k] = columns[k % 2 * n + k / 2];
  return u;
}

bool Componentwise::is_direct() const
{
  return one->is_direct();
}

} // namespace Voussoir
