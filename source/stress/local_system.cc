// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/local_system.h>

#include <cmath>

namespace Voussoir
{
namespace
{
/**
 * Up to this size LAPACK is faster, by half for the systems of Fan; up to 400
 * the two differ little (measured with Debian's reference BLAS).
 */
constexpr unsigned int largest_small_system = 80;
} // namespace

LocalSystem::LocalSystem(const dealii::DynamicSparsityPattern &entries)
    : is_small(entries.n_rows() <= largest_small_system)
{
  if (is_small)
    dense.reinit(entries.n_rows());
  else
  {
    pattern.copy_from(entries);
    sparse.reinit(pattern);
  }
}

void LocalSystem::clear()
{
  if (is_small)
    dense = 0.;
  else
    sparse = 0.;
}

bool LocalSystem::solve(dealii::Vector<double> &x)
{
  try
  {
    if (is_small)
    {
      dense.compute_lu_factorization();
      dense.solve(x);
    }
    else
    {
      dealii::SparseDirectUMFPACK factor;
      factor.factorize(sparse);
      factor.solve(x);
    }
  }
  catch (const dealii::LACExceptions::ExcSingular &)
  {
    return false;
  }
  catch (const dealii::SparseDirectUMFPACK::ExcUMFPACKError &)
  {
    return false;
  }
  for (const double value : x)
    if (!std::isfinite(value))
      return false;
  return true;
}
} // namespace Voussoir
