// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_quadratic_cone_h
#define voussoir_statics_conic_quadratic_cone_h

#include <array>
#include <cmath>

namespace Voussoir
{
/**
 * The second-order cone of all v in three dimensions with v_0 > |v_t|, where
 * v_t is (v_1, v_2), its product v o w, and the scaling of Nesterov and Todd,
 * *SIAM Journal on Optimization* 8 (1998), 324, of a pair of slack s and
 * multiplier z.
 */
namespace QuadraticCone
{
/** A vector, the head first. */
using Vector = std::array<double, 3>;

/** |v_t|. */
inline double size_of_tail(const Vector &v)
{
  return std::sqrt(v[1] * v[1] + v[2] * v[2]);
}

/** v_t . w_t. */
inline double tail_product(const Vector &v, const Vector &w)
{
  return v[1] * w[1] + v[2] * w[2];
}

/** J v. */
inline Vector reflected(const Vector &v)
{
  return {{v[0], -v[1], -v[2]}};
}

/** The product with a number. */
inline Vector scaled(const double factor, Vector v)
{
  for (double &component : v)
    component *= factor;
  return v;
}

/** (2 w w^T - J) v. */
inline Vector times_square_of(const Vector &w, const Vector &v)
{
  const double twice = 2. * (w[0] * v[0] + tail_product(w, v));
  return {{twice * w[0] - v[0], twice * w[1] + v[1], twice * w[2] + v[2]}};
}

/** The root of 2 w w^T - J, times v. */
inline Vector times_root_of(const Vector &w, const Vector &v)
{
  const double of_tails = tail_product(w, v);
  const double along = v[0] + of_tails / (1. + w[0]);
  return {{w[0] * v[0] + of_tails, v[1] + along * w[1], v[2] + along * w[2]}};
}

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

// ------------------------------------------------------------------- inline

inline double det(const Vector &v)
{
  const double tail = size_of_tail(v);
  return (v[0] - tail) * (v[0] + tail);
}

inline bool contains(const Vector &v)
{
  return v[0] > size_of_tail(v);
}

inline Vector product(const Vector &v, const Vector &w)
{
  return {{v[0] * w[0] + tail_product(v, w), v[0] * w[1] + w[0] * v[1],
           v[0] * w[2] + w[0] * v[2]}};
}

inline Vector quotient(const Vector &v, const Vector &right)
{
  const double head = (v[0] * right[0] - tail_product(v, right)) / det(v);
  return {
      {head, (right[1] - head * v[1]) / v[0], (right[2] - head * v[2]) / v[0]}};
}

inline std::array<double, 2> eigenvalues(const Vector &v)
{
  const double tail = size_of_tail(v);
  return {{v[0] - tail, v[0] + tail}};
}

inline Vector with_eigenvalues(const Vector &v,
                               const std::array<double, 2> &values)
{
  const double tail = size_of_tail(v);
  const double half = 0.5 * (values[1] - values[0]);
  Vector result = {{0.5 * (values[0] + values[1]), 0., 0.}};
  if (tail > 0.)
    for (unsigned int i = 1; i < 3; ++i)
      result[i] = half * (v[i] / tail);
  return result;
}

inline double inverse_of_longest(const Vector &v, const Vector &d)
{
  const double root = std::sqrt(det(v));
  const Vector unit = scaled(1. / root, v);
  const double head = unit[0] * d[0] - tail_product(unit, d);
  const double c = (head + d[0]) / (unit[0] + 1.);
  const Vector rest = {{0., d[1] - c * unit[1], d[2] - c * unit[2]}};
  return (size_of_tail(rest) - head) / root;
}

inline Scaling Scaling::of(const Vector &s, const Vector &z)
{
  const double root_s = std::sqrt(det(s)), root_z = std::sqrt(det(z));
  const Vector of_s = scaled(1. / root_s, s), of_z = scaled(1. / root_z, z);
  const double cosine = of_s[0] * of_z[0] + tail_product(of_s, of_z);
  const double twice_gamma = 2. * std::sqrt(0.5 * (1. + cosine));
  Vector w = {{0., (of_s[1] - of_z[1]) / twice_gamma,
               (of_s[2] - of_z[2]) / twice_gamma}};
  w[0] = std::sqrt(1. + tail_product(w, w));
  return {w, root_s / root_z};
}

inline Scaling Scaling::of_barrier(const Vector &s)
{
  const double square = det(s);
  Vector w = scaled(1. / std::sqrt(square), s);
  w[0] = std::sqrt(1. + tail_product(w, w));
  return {w, square};
}

inline Scaling Scaling::of_dual_barrier(const Vector &z)
{
  const Scaling inverse = of_barrier(z);
  return {reflected(inverse.w), 1. / inverse.eta_squared};
}

inline Vector Scaling::times(const Vector &v) const
{
  return scaled(std::sqrt(eta_squared), times_root_of(w, v));
}

inline Vector Scaling::over(const Vector &v) const
{
  return scaled(1. / std::sqrt(eta_squared), times_root_of(reflected(w), v));
}

inline Vector Scaling::over_square(const Vector &v) const
{
  return scaled(1. / eta_squared, times_square_of(reflected(w), v));
}

inline Vector Scaling::times_square(const Vector &v) const
{
  return scaled(eta_squared, times_square_of(w, v));
}
} // namespace QuadraticCone
} // namespace Voussoir

#endif
