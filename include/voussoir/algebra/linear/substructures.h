// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_substructures_h
#define voussoir_algebra_linear_substructures_h

#include <voussoir/algebra/linear/joint_blocks.h>
#include <voussoir/algebra/linear/linear_method.h>
#include <voussoir/algebra/linear/sparse_factor.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace Voussoir
{
/**
 * Direct substructuring, for a structure that several processes share.
 *
 * Each eliminates by CHOLMOD the bodies that touch no body of another process,
 * or only bodies of earlier ones, and the root solves for the others, the
 * coupling bodies, whose matrix is the sum of the Schur complements of all
 * parts.
 *
 * So a body couples if it touches a body of a later process. A joint between
 * two processes belongs to the later one, for which the body at its far end, a
 * ghost, is a coupling one.
 */
class Substructures : public LinearMethod
{
public:
  /** @param blocks of the matrix. */
  explicit Substructures(const JointBlocks &blocks);

  /** The number of own bodies of this process that couple. */
  static unsigned int n_coupling_bodies(const Structure &structure);

  bool prepare(const std::vector<double> &coefficients, double shift) override;
  std::vector<double> solve(const std::vector<double> &r,
                            unsigned int n_columns) override;
  bool is_direct() const override;

private:
  void number_couplings();
  std::vector<double> schur_complement() const;
  bool factorise_couplings(const std::vector<std::vector<double>> &parts);
  std::vector<double> solve_couplings(const std::vector<double> &right,
                                      unsigned int n_columns) const;

  const JointBlocks blocks;
  const Structure &structure;
  /** Own bodies and the ghosts of earlier processes. */
  const unsigned int n_bodies;
  SparseFactor factor;
  /** The coupling unknowns in their order; see SparseFactor. */
  std::vector<unsigned int> coupled;
  bool is_numbered = false;
  /** On the root: the rows of these unknowns of each process, and how many. */
  std::vector<std::vector<unsigned int>> rows;
  unsigned int n_rows = 0;
  dealii::LAPACKFullMatrix<double> couplings;
};
} // namespace Voussoir

#endif
