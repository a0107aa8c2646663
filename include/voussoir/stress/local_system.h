// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_local_system_h
#define voussoir_stress_local_system_h

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

namespace Voussoir
{
/**
 * The linear system of one cell, symmetric and indefinite: by dense
 * elimination where it is small, by UMFPACK where it is not.
 */
class LocalSystem
{
public:
  /** For matrices with entries in @p pattern. */
  explicit LocalSystem(const dealii::DynamicSparsityPattern &pattern);

  /** Set all entries of the matrix to zero. */
  void clear()
  {
    if (is_small)
      dense = 0.;
    else
      sparse = 0.;
  }

  /** Add to entry (i, j) of the matrix; both triangles are given. */
  void add(const unsigned int i, const unsigned int j, const double value)
  {
    if (is_small)
      dense(i, j) += value;
    else
      sparse.add(i, j, value);
  }

  /**
   * Replace the right-hand side @p x by the solution.
   *
   * @return false if the matrix is singular, or the solution not finite.
   */
  bool solve(dealii::Vector<double> &x);

private:
  bool eliminate(dealii::Vector<double> &x);

  const bool is_small;
  dealii::FullMatrix<double> dense;
  dealii::SparsityPattern pattern;
  dealii::SparseMatrix<double> sparse;
};
} // namespace Voussoir

#endif
