// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_bounded_forces_h
#define voussoir_statics_conic_bounded_forces_h

#include <voussoir/algebra/linear/sparse_factor.h>
#include <voussoir/statics/conic/bounded_rows.h>

#include <vector>

namespace Voussoir
{
/**
 * The forces x of rows within their bounds, what they add up to on the bodies,
 * and the normal equations of that. A x is the sum of forces on the bodies, and
 * A^T u are minus the jumps.
 *
 * A function c . x of the forces between two bodies may be one more row of A,
 * the last: then one more unknown, behind those of the bodies, goes with it.
 */
class BoundedForces
{
public:
  /** A bound, sign times the force of a row at most the limit. */
  struct Bound
  {
    /** The number of the row among all. */
    unsigned int row;
    /** 1 or -1. */
    double sign;
    /** The largest value, not negative: zero is within all bounds. */
    double limit;
  };

  /**
   * @param rows must outlive this object.
   * @param held true for the bodies that do not move and need no balance.
   */
  BoundedForces(const BoundedRows &rows, std::vector<bool> held);
  /**
   * With the function of the coefficients @p c, n_all_rows() numbers, of which
   * those of the rows between two bodies are not zero.
   */
  BoundedForces(const BoundedRows &rows,
                std::vector<bool> held,
                const std::vector<double> &c);

  /** The rows. */
  const BoundedRows &of() const { return rows; }
  /** True for the bodies that do not move. */
  const std::vector<bool> &held_bodies() const { return held; }
  /** All bounds, in the order of the rows, of which each has up to two. */
  const std::vector<Bound> &bounds() const { return all_bounds; }
  /** The number of unknowns: those of the bodies, and that of the function. */
  unsigned int n_unknowns() const
  {
    return rows.n_dofs() + (of_function.empty() ? 0 : 1);
  }
  /** A x, n_unknowns() numbers; zero for held bodies. */
  std::vector<double> on_bodies(const std::vector<double> &x) const;
  /**
   * A^T u, one number a row, zero where there is no force; u is zero for held
   * bodies.
   */
  std::vector<double> along(const std::vector<double> &u) const;
  /** Sign times the force of the row, for each bound. */
  std::vector<double> at_bounds(const std::vector<double> &x) const;
  /** The sum over the bounds of each row, of sign times what each has. */
  std::vector<double> of_rows(const std::vector<double> &z) const;
  /** The inverse of the sum over the bounds of each row; zero without bounds.*/
  std::vector<double> inverse_sums(const std::vector<double> &weights) const;
  /** Set what @p loads, n_unknowns() numbers, has for held bodies to zero. */
  void clear_held(std::vector<double> &loads) const;

  /** Factorise by SparseFactor::avoid_blas(); to be called before prepare(). */
  void avoid_blas() { factor.avoid_blas(); }
  /**
   * Factorise A diag(k) A^T, with a relative shift of its diagonal that makes
   * it definite. The unknown of the function, if there is one, is eliminated
   * first: that leaves of its rows, with the sum s of all c_r^2 k_r, the
   * coefficients k_r k_s / s of c_s times row r less c_r times row s, and no
   * difference of large numbers.
   *
   * @param k one number for each row, not negative.
   * @return false if no shift helps.
   */
  bool prepare(std::vector<double> k);
  /**
   * Solve with that matrix without the shift, by conjugate gradients that the
   * factors precondition.
   *
   * @param right n_unknowns() numbers.
   * @param enough the largest component of a residual to stop at.
   * @param n_gradients the largest number of steps.
   */
  std::vector<double> solve(const std::vector<double> &right,
                            double enough,
                            unsigned int n_gradients);
  /** A diag(k) A^T times @p u, of the matrix that is prepared. */
  std::vector<double> product(const std::vector<double> &u) const;

private:
  const BoundedRows &rows;
  const std::vector<bool> held;
  std::vector<Bound> all_bounds;
  /** Rows whose bounds are both zero. */
  std::vector<unsigned int> without_force;
  std::vector<double> weights;
  SparseFactor factor;
  bool factorise(double shift);
  std::vector<double> precondition(const std::vector<double> &right);

  /** A coefficient of the function. */
  struct Coefficient
  {
    unsigned int row;
    double c;
  };
  std::vector<Coefficient> of_function;
  /** The sum of all c_r^2 k_r, and A diag(k) c on the bodies. */
  double own_stiffness = 0.;
  std::vector<double> coupling;
};
} // namespace Voussoir

#endif
