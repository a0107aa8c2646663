// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_quadratic_cone_h
#define voussoir_statics_conic_quadratic_cone_h

#include <array>

namespace Voussoir
{
/**
 * The second-order cone of all v in three dimensions with v_0 > |(v_1, v_2)|,
 * its product v o w, and the scaling of Nesterov and Todd, *SIAM Journal on
 * Optimization* 8 (1998), 324, of a pair of slack s and multiplier z.
 */
namespace QuadraticCone
{
/** A vector, the head first. */
using Vector = std::array<double, 3>;

/** v_0^2 - v_1^2 - v_2^2, without cancellation; positive inside. */
double det(const Vector &v);
/** True if @p v is strictly inside. */
bool contains(const Vector &v);
/** The product v o w = (v . w, v_0 w_t + w_0 v_t). */
Vector product(const Vector &v, const Vector &w);
/** The r with v o r = @p right, for v inside. */
Vector quotient(const Vector &v, const Vector &right);
/** The two eigenvalues v_0 +- |v_t|, the lesser first. */
std::array<double, 2> eigenvalues(const Vector &v);
/** The vector with the eigenvectors of @p v and other eigenvalues. */
Vector with_eigenvalues(const Vector &v, const std::array<double, 2> &values);
/**
 * The inverse of the longest multiple of the step @p d that stays inside from
 * @p v; not positive if all do.
 */
double inverse_of_longest(const Vector &v, const Vector &d);

/**
 * A scaling W = eta (2 v v^T - J)^(1/2) with det w = 1, J = diag(1, -1, -1), by
 * its square W^2 = eta^2 (2 w w^T - J).
 */
struct Scaling
{
  /** w. */
  Vector w;
  /** eta^2, positive. */
  double eta_squared;

  /** That with W z = W^-1 s, for both inside. */
  static Scaling of(const Vector &s, const Vector &z);
  /** That with W^-2 the second derivative of -log(det(s)) / 2 at s. */
  static Scaling of_barrier(const Vector &s);
  /** That with W^2 the second derivative of -log(det(z)) / 2 at z. */
  static Scaling of_dual_barrier(const Vector &z);

  /** W v. */
  Vector times(const Vector &v) const;
  /** W^-1 v. */
  Vector over(const Vector &v) const;
  /** W^-2 v. */
  Vector over_square(const Vector &v) const;
  /** W^2 v. */
  Vector times_square(const Vector &v) const;
};
} // namespace QuadraticCone
} // namespace Voussoir

#endif
