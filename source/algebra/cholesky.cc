// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/cholesky.h>

namespace Voussoir
{
Cholesky::Cholesky(const Structure &structure, const unsigned int n_components)
    : n_components(n_components),
      factor(structure, n_components, structure.n_bodies())
{
}

bool Cholesky::prepare(const std::vector<Structure::Jump> &coefficients,
                       const double shift)
{
  return factor.factorise(coefficients, shift);
}

std::vector<double> Cholesky::solve(const std::vector<double> &r)
{
  return from_columns(
      factor.solve(to_columns(r, n_components), 2 / n_components),
      n_components);
}

bool Cholesky::is_direct() const
{
  return true;
}
} // namespace Voussoir
