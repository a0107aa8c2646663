// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_multigrid_h
#define voussoir_algebra_multigrid_h

#include <voussoir/algebra/linear_method.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

namespace Voussoir
{
/** The conjugate gradients of deal.II with Trilinos' matrix and ML. */
class Multigrid : public LinearMethod
{
public:
  /**
   * @param structure must outlive this object.
   * @param n_components of the system, one or two; see LinearMethod.
   */
  Multigrid(const Structure &structure, unsigned int n_components);

  bool prepare(const std::vector<Structure::Jump> &coefficients,
               double shift) override;
  std::vector<double> solve(const std::vector<double> &r) override;
  bool is_direct() const override;

private:
  dealii::types::global_dof_index row(unsigned int body, unsigned int i) const;
  void assemble(const std::vector<Structure::Jump> &coefficients, double shift);

  const Structure &structure;
  const unsigned int n_components;
  dealii::TrilinosWrappers::SparseMatrix matrix;
  dealii::TrilinosWrappers::PreconditionAMG preconditioner;
  dealii::TrilinosWrappers::MPI::Vector right, solution;
};
} // namespace Voussoir

#endif
