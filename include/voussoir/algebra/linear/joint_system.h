// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_joint_system_h
#define voussoir_algebra_linear_joint_system_h

#include <voussoir/algebra/linear/linear_method.h>
#include <voussoir/algebra/structure.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <memory>
#include <vector>

namespace Voussoir
{
/**
 * The shift with which a system is meant to have none, for matrices with
 * entries of order one: far below what the forces could show, far enough above
 * rounding for a factorisation.
 */
constexpr double least_shift = 1e-13;
/** The factor from one shift to the next when a factorisation fails. */
constexpr double factor_of_shift = 100.;

/** The solver of the linear systems; see JointSystem. */
enum class LinearSolver
{
  /** The one that is faster at the size of the problem. */
  automatic,
  /** Cholesky, or Substructures on several processes. */
  direct,
  /** Conjugate gradients with Multigrid. */
  multigrid
};

/** Declare the entry `Linear solver` in the present section and bind it. */
void add_linear_solver(dealii::ParameterHandler &prm, LinearSolver &solver);

/**
 * The linear systems of Newton's method: find u with
 *
 *     (sum_e B_e^T A_e B_e + shift) u = r,
 *
 * where B_e u are the jumps in the rows of joint e, A_e has the blocks of its
 * sets of rows, B_e^T A_e B_e is positive semidefinite, and the shift is
 * positive, so that the matrix is symmetric and positive definite. Where all
 * joints are as stiff in one direction as in the other, Componentwise takes
 * half of the matrix, and of bodies that turn RotationComplement takes the
 * rest. Where a residual is admitted NearComponentwise serves joints that are
 * not far from that.
 *
 * `direct` is the sparse Cholesky factorisation of CHOLMOD; several processes
 * factorise each its own part, and the root what couples them; see
 * Substructures. `multigrid` is the method of conjugate gradients with
 * Trilinos' algebraic multigrid ML, for which MPI begins.
 * `automatic` takes what is faster at the size of the problem.
 * prepare() and solve() are collective.
 */
class JointSystem
{
public:
  /**
   * @param structure has the joints; it must outlive this object.
   * @param kind of solver.
   * @param residual that is admitted, relative to the right-hand side, by the
   *   norm; zero for all the digits that there are.
   */
  JointSystem(const Structure &structure,
              LinearSolver kind,
              double residual = 0.);

  /**
   * Prepare to solve with the given coefficients.
   *
   * @return false if a factorisation found that rounding has cost the matrix
   *   its positive definiteness; a larger shift helps then.
   */
  bool prepare(const JointStiffnesses &coefficients, double shift);

  /**
   * The solution for the right-hand side @p r, of which that of own bodies
   * counts; with the ghosts. n_dofs() numbers each; not finite where rounding
   * is found to cost the matrix its positive definiteness only now.
   */
  std::vector<double> solve(const std::vector<double> &r);

  /** True if another solve() costs little after a prepare(). */
  bool is_direct() const;

  /** The time that prepare() and solve() have taken so far; seconds. */
  double seconds() const;

private:
  std::unique_ptr<LinearMethod> make(bool apart) const;
  bool comes_apart(const JointStiffnesses &coefficients) const;
  std::unique_ptr<LinearMethod> make_componentwise() const;
  bool prepare_coupled(const std::vector<double> &coefficients, double shift);

  const Structure &structure;
  const LinearSolver kind;
  const double residual;
  /** @{ */
  /** Made when first needed. */
  std::unique_ptr<LinearMethod> componentwise, coupled;
  /** @} */
  LinearMethod *current = nullptr;
  /** The arguments of prepare(), of what conjugate gradients may give up. */
  struct
  {
    std::vector<double> coefficients;
    double shift;
  } prepared;
  dealii::Timer timer;
};
} // namespace Voussoir

#endif
