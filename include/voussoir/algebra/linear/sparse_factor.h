// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_sparse_factor_h
#define voussoir_algebra_linear_sparse_factor_h

#include <voussoir/algebra/linear/joint_blocks.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>
#include <vector>

struct cholmod_common_struct;
struct cholmod_sparse_struct;
struct cholmod_factor_struct;

namespace Voussoir
{
/**
 * The matrix of a system of JointSystem, of the first bodies of a structure and
 * the joints between them, with its sparse Cholesky factors by CHOLMOD. The
 * lower triangle is stored by columns in the order of the elimination, so that
 * CHOLMOD need not copy it; where the entries of each joint go is found once.
 */
class SparseFactor
{
public:
  /**
   * Find the pattern of the matrix.
   *
   * @param blocks of the matrix.
   * @param n_bodies the number of bodies that count; not fewer than are own.
   * @param last bodies to be eliminated after all others, ascending.
   * @param held true for bodies whose unknowns are zero; empty if there are
   *   none.
   * @throws std::bad_alloc if there is not enough memory.
   * @throws SolverError if CHOLMOD fails otherwise, here and below.
   */
  SparseFactor(const JointBlocks &blocks,
               unsigned int n_bodies,
               const std::vector<unsigned int> &last = {},
               const std::vector<bool> &held = {});
  ~SparseFactor();
  SparseFactor(const SparseFactor &) = delete;
  SparseFactor &operator=(const SparseFactor &) = delete;

  /** A row beside those of the structure, between the bodies of a joint. */
  struct FurtherRow
  {
    /** The number of the joint. */
    unsigned int joint;
    /** The row. */
    ContactRow row;
    /** Its coefficient. */
    double coefficient;
  };

  /**
   * Fill in the coefficients and the shift of own bodies, and factorise. To the
   * diagonal of each of the last bodies its largest entry is added, so that
   * there are factors whatever else holds these bodies; see added().
   *
   * @param coefficients of all rows of all joints.
   * @param shift added to the diagonal.
   * @param relative_shift multiplies each entry of the diagonal by one more
   *   than it.
   * @param further rows.
   * @return false if the matrix is not positive definite.
   * @throws std::bad_alloc if there is not enough memory, and where CHOLMOD's
   *   integers are too small.
   */
  bool factorise(const std::vector<double> &coefficients,
                 double shift,
                 double relative_shift = 0.,
                 const std::vector<FurtherRow> &further = {});

  /**
   * Factorise without BLAS, column by column: slower, and to the last bit the
   * same whatever kernels a BLAS has. To be called before factorise().
   */
  void avoid_blas() { without_blas = true; }

  /**
   * The number of entries of the factors, of eight bytes each; infinite where
   * it is too large for CHOLMOD's integers.
   */
  double n_entries();

  /** The number of unknowns: JointBlocks::n() times n_bodies. */
  unsigned int n() const;

  /** The number of them that belong to the last bodies. */
  unsigned int n_last() const;

  /**
   * Solve for @p r, ordered by unknowns; @p n_columns right-hand sides, one
   * behind the other. Several threads may do so at once.
   */
  std::vector<double> solve(const std::vector<double> &r,
                            unsigned int n_columns) const;

  // ------------------------------------------ for the last bodies, if any

  /**
   * Half of solve(): L^{-1} P r, ordered as the unknowns are eliminated, so
   * that the last come last.
   */
  std::vector<double> forward(const std::vector<double> &r,
                              unsigned int n_columns) const;
  /** The other half: P^T L^{-T} y, ordered by unknowns. */
  std::vector<double> backward(const std::vector<double> &y,
                               unsigned int n_columns) const;

  /** The unknowns of the last bodies in the order of their elimination. */
  std::vector<unsigned int> last_unknowns() const;

  /** The lower triangular block of L of the last bodies. */
  const dealii::FullMatrix<double> &last_block() const;

  /** The number added to the diagonal of each of the last_unknowns(). */
  std::vector<double> added() const;

private:
  /** The joints of each body to those behind it. */
  struct Below;
  std::vector<int> find_order();
  void make_pattern();
  bool is_held(const unsigned int body) const
  {
    return !held.empty() && held[body];
  }
  void fill(const std::vector<double> &coefficients,
            double shift,
            double relative_shift,
            const std::vector<FurtherRow> &further);
  bool is_between_bodies(unsigned int joint) const;
  void add(unsigned int joint, const JointBlocks::Blocks &of);
  void hold_bodies(double relative_shift);
  void analyse();
  void extract_last_block();
  /** Solve one of CHOLMOD's systems, ordered as unknowns are eliminated. */
  std::vector<double>
  solve(int system, const std::vector<double> &r, unsigned int n_columns) const;
  /** @{ */
  /** From the order of unknowns to that of their elimination, and back. */
  std::vector<double> in_order(const std::vector<double> &r,
                               unsigned int n_columns) const;
  std::vector<double> by_bodies(const std::vector<double> &y,
                                unsigned int n_columns) const;
  std::vector<double> reordered(const std::vector<double> &values,
                                unsigned int n_columns,
                                bool to_elimination) const;
  /** @} */

  const JointBlocks blocks;
  const Structure &structure;
  const unsigned int n_bodies;
  const std::vector<unsigned int> last;
  const std::vector<bool> held;
  bool without_blas = false;
  std::unique_ptr<cholmod_common_struct> common;
  cholmod_sparse_struct *matrix = nullptr;
  cholmod_factor_struct *factor = nullptr;
  /** The bodies in the order of their elimination, that of the matrix. */
  std::vector<int> order;
  /** The place of the diagonal entry of each unknown. */
  std::vector<int> of_body;
  /** The place of the first entry of each column of each joint's block. */
  std::vector<int> of_joint;
  /** Of each of the last bodies. */
  std::vector<double> addition;
  dealii::FullMatrix<double> block;
};
} // namespace Voussoir

#endif
