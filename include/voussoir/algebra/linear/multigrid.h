// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_multigrid_h
#define voussoir_algebra_linear_multigrid_h

#include <voussoir/algebra/linear/joint_blocks.h>
#include <voussoir/algebra/linear/linear_method.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

namespace Voussoir
{
/** The conjugate gradients of deal.II with Trilinos' matrix and ML. */
class Multigrid : public LinearMethod
{
public:
  /** @param blocks of the matrix. */
  explicit Multigrid(const JointBlocks &blocks);

  bool prepare(const std::vector<double> &coefficients, double shift) override;
  std::vector<double> solve(const std::vector<double> &r,
                            unsigned int n_columns) override;
  bool is_direct() const override;

private:
  dealii::types::global_dof_index row(unsigned int body, unsigned int i) const;
  void assemble(const std::vector<double> &coefficients, double shift);

  const JointBlocks blocks;
  const Structure &structure;
  dealii::TrilinosWrappers::SparseMatrix matrix;
  dealii::TrilinosWrappers::PreconditionAMG preconditioner;
  dealii::TrilinosWrappers::MPI::Vector right, solution;
};
} // namespace Voussoir

#endif
