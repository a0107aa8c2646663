// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/linear/cholesky.h>

namespace Voussoir
{

Cholesky::Cholesky(const JointBlocks &blocks)
    : factor(blocks, blocks.of().n_bodies())
{}

bool Cholesky::prepare(const std::vector<double> &coefficients,
                       const double shift)
{
  return factor.factorise(coefficients, shift);
}

std::vector<double> Cholesky::solve(const std::vector<double> &r,
                                    const unsigned int n_columns)
{
  return factor.solve(r, n_columns);
}

bool Cholesky::is_direct() const
{
  return true;
}

} // namespace Voussoir
