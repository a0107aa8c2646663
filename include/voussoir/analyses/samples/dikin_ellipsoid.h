// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_samples_dikin_ellipsoid_h
#define voussoir_analyses_samples_dikin_ellipsoid_h

#include <voussoir/analyses/ranges/extreme_states.h>
#include <voussoir/statics/conic/feasible_state.h>

#include <cstddef>
#include <vector>

namespace Voussoir
{
/**
 * The balance of forces in a metric: of all forces that balance, the nearest
 * to given ones, where each force has a weight, the square of its unit; those
 * without weight stay as they are.
 *
 * It avoids the BLAS, so that equal numbers give equal ones on every processor:
 * a walk that is reflected over and over forgets where it was within rounding.
 */
class BalancedForces
{
public:
  /** @param problem must outlive this object. */
  explicit BalancedForces(const DiscreteProblem &problem);

  /**
   * @throws SolverError if no digits are left, as with forces of very different
   *   sizes.
   */
  void set_weights(std::vector<double> weights);
  /** The forces nearest to @p x that balance by themselves. */
  void balance(std::vector<double> &x) const;
  /** The forces nearest to @p x that balance the loads. */
  void balance_loads(std::vector<double> &x) const;

private:
  void subtract(const std::vector<double> &imbalance,
                std::vector<double> &x) const;

  mutable RowProblem by_rows;
  std::vector<double> loads;
  std::vector<double> weights;
};

/**
 * Dikin's ellipsoid of a polytope of states at its analytic centre,
 *
 *     (x - x_c)^T H (x - x_c) <= 1,  A (x - x_c) = 0,
 *
 * with the diagonal H of the second derivatives of -sum log(room) over the
 * limits. It is inside of the polytope, and as many times as large as there are
 * limits it has all of it (Nesterov and Nemirovskii, *Interior-Point Polynomial
 * Algorithms in Convex Programming*, 1994), so that it makes the polytope
 * round: in its metric no direction is much longer than another. Friction that
 * grows with the pressure couples the forces of a joint, which the diagonal
 * leaves out; any ellipsoid serves.
 */
class DikinEllipsoid
{
public:
  /**
   * Find the centre from ExtremeStates::middle(), by Newton's method.
   *
   * @throws SolverError as BalancedForces::set_weights() does.
   */
  DikinEllipsoid(const StatePolytope &polytope, const ExtremeStates &extremes);

  /** x_c. */
  const std::vector<double> &centre() const { return x; }
  /** The diagonal of the inverse of H; zero for forces that do not vary. */
  const std::vector<double> &weights() const { return inverse; }
  /**
   * Column @p r of the covariance C: of forces that balance by themselves,
   * those that do most work on force r. Its rows and columns of forces that do
   * not vary are zero.
   */
  const double *column(const std::size_t r) const { return &columns[r * n]; }
  /**
   * A state close to @p share of the way from the centre to @p to, with digits
   * that do not depend on the last ones of that.
   */
  std::vector<double> towards(const std::vector<double> &to,
                              double share) const;

private:
  void find_centre(const StatePolytope &polytope,
                   const ExtremeStates &extremes);
  void find_columns();

  const std::size_t n;
  BalancedForces balanced;
  std::vector<double> x, inverse, columns;
};
} // namespace Voussoir

#endif
