// SPDX-License-Identifier: LGPL-2.1-or-later
/* The linear systems of ConicForces. */
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/conic/conic_forces.h>
#include <voussoir/statics/conic/sum_of_squares.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/** The relative shifts of the diagonal: the first, the factor to the next. */
constexpr double first_shift_of_forces = 1e-14, factor_of_force_shift = 100.,
                 largest_force_shift = 1e-2;

/**
 * K of rows without any limit at least, and over the largest of bounds. It
 * would be infinite; a finite one leaves jumps, which later steps remove.
 */
constexpr double least_without_limit = 1e8, stiffer_without_limit = 1e4;

/** The steps of conjugate gradients that may bring nothing. */
constexpr unsigned int n_without_gain = 10;

/** B^T v of one cone. */
std::array<double, 3> transposed(const ConicForces::Cone &cone,
                                 const QuadraticCone::Vector &v)
{
  std::array<double, 3> sum = {};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < cone.n_rows; ++j)
      sum[j] += cone.b[i][j] * v[i];
  return sum;
}

/**
 * Add B^T W^-2 B of one cone: 2 w w^T - J. Of -B^T J B the head is nothing in
 * an arc, and in a section what the first of the tail is.
 */
void add_cone(const ConicForces::Cone &cone,
              const QuadraticCone::Scaling &scaling,
              SumOfSquares &sum)
{
  const QuadraticCone::Vector &w = scaling.w;
  sum.add(2. / scaling.eta_squared, transposed(cone, {{w[0], -w[1], -w[2]}}));
  sum.add(1. / scaling.eta_squared, cone.b[2]);
  if (cone.b[0] != cone.b[1])
    sum.add(1. / scaling.eta_squared, cone.b[1]);
}

/** The same of three rows, by the eigenvectors of W^-2. */
void add_cone(const ConicForces::Cone &cone,
              const QuadraticCone::Scaling &scaling,
              SumOfSquaresOfThree &sum)
{
  const QuadraticCone::Vector &w = scaling.w;
  const double tail = QuadraticCone::size_of_tail(w);
  const std::array<double, 2> t =
      tail > 0. ? std::array<double, 2>{{w[1] / tail, w[2] / tail}}
                : std::array<double, 2>{{1., 0.}};
  const double large = (w[0] + tail) * (w[0] + tail);
  const double half = 0.5 / scaling.eta_squared;
  sum.add(half * large, transposed(cone, {{1., -t[0], -t[1]}}));
  sum.add(half / large, transposed(cone, {{1., t[0], t[1]}}));
  sum.add(2. * half, transposed(cone, {{0., -t[1], t[0]}}));
}
} // namespace

std::vector<double> ConicForces::of_rows(const std::vector<double> &z) const
{
  std::vector<double> result(rows.n_all_rows(), 0.);
  for (std::size_t b = 0; b < all_bounds.size(); ++b)
    result[all_bounds[b].row] += all_bounds[b].sign * z[b];
  const auto add_cones = [&](const std::size_t begin, const std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
    {
      const std::array<double, 3> sum = transposed(all_cones[k], of_cone(z, k));
      for (unsigned int r = 0; r < all_cones[k].n_rows; ++r)
        result[all_cones[k].row + r] += sum[r];
    }
  };
  // In the plane two cones have the rows of one section.
  if (rows.is_plane())
    add_cones(0, all_cones.size());
  else
    for_chunks(all_cones.size(), light_items_of_a_chunk,
               [&](std::size_t, const std::size_t begin,
                   const std::size_t end) { add_cones(begin, end); });
  return result;
}

bool ConicForces::prepare(const Weights &weights,
                          const bool with_curvature,
                          const double proximal)
{
  std::vector<double> &k = coefficients;
  k.assign(rows.n_all_rows(), 0.);
  if (with_curvature)
    k = of_cost;
  for (std::size_t b = 0; b < all_bounds.size(); ++b)
    k[all_bounds[b].row] += weights.of_bounds[b];
  for (double &sum : k)
    if (sum > 0.)
      sum = 1. / (sum + proximal);
  if (!rows_without_limits.empty())
  {
    const double most =
        std::max(least_without_limit,
                 stiffer_without_limit * *std::max_element(k.begin(), k.end()));
    for (const unsigned int row : rows_without_limits)
      if (k[row] == 0.)
        k[row] = most;
  }
  for (const Cone &cone : all_cones)
    if (cone.bound >= 0)
      k[cone.row] = 1. / (weights.of_bounds[cone.bound] +
                          (with_curvature ? of_cost[cone.row] : 0.));
  clear_without_force(k);
  scalings.clear();
  if (!rows.is_plane() && !with_curvature)
  {
    scalings = weights.of_cones;
    outside_cones = k;
    of_their_bounds.clear();
    for (const Cone &cone : all_cones)
      of_their_bounds.push_back(cone.bound < 0 ? 0.
                                               : weights.of_bounds[cone.bound]);
  }
  if (rows.has_blocks())
    invert_sets(weights, with_curvature);
  return factorise();
}

bool ConicForces::prepare_diagonal(std::vector<double> k)
{
  AssertDimension(all_cones.size(), 0);
  coefficients = std::move(k);
  return factorise();
}

bool ConicForces::factorise()
{
  border.clear();
  for (const double coefficient : coefficients)
    if (!std::isfinite(coefficient))
      return false;
  for (double shift = first_shift_of_forces; shift <= largest_force_shift;
       shift *= factor_of_force_shift)
    if (factor.factorise(coefficients, 0., shift))
      return true;
  return false;
}

/**
 * The block of a set: the inverse of the sum of its @p n cones from @p first
 * on, and what its rows have besides.
 */
void ConicForces::invert_set(const std::size_t first,
                             const std::size_t n,
                             const Weights &weights,
                             const bool with_curvature,
                             double *const block) const
{
  const std::size_t r = all_cones[first].row;
  if (all_cones[first].n_rows == 3)
  {
    SumOfSquaresOfThree sum;
    add_cone(all_cones[first], weights.of_cones[first], sum);
    // What bounds and the cost have on the diagonal, see prepare().
    for (unsigned int i = 0; i < 3; ++i)
      if (const double k = coefficients[r + i]; k > 0.)
      {
        std::array<double, 3> g = {};
        g[i] = 1.;
        sum.add(1. / k, g);
      }
    sum.find_inverse(block);
    return;
  }
  SumOfSquares sum;
  if (with_curvature)
  {
    sum.add(of_cost[r], {{1., 0., 0.}});
    sum.add(of_cost[r + 1], {{0., 1., 0.}});
  }
  for (std::size_t k = first; k < first + n; ++k)
    add_cone(all_cones[k], weights.of_cones[k], sum);
  const std::array<double, 3> inverse = sum.inverse();
  block[0] = inverse[0];
  block[1] = block[2] = inverse[1];
  block[3] = inverse[2];
}

/** Spread what rows have to the coefficients of sets, and add those of cones.
 */
void ConicForces::invert_sets(const Weights &weights, const bool with_curvature)
{
  std::vector<double> of_sets(rows.n_all_coefficients(), 0.);
  for_chunks(
      rows.joints().size(), items_of_a_chunk,
      [&](std::size_t, const unsigned int begin, const unsigned int end) {
        // The cones are in the order of the rows.
        auto cone = std::lower_bound(
            all_cones.begin(), all_cones.end(), rows.first_row(begin),
            [](const Cone &one, const std::size_t row) {
              return one.row < row;
            });
        for (unsigned int e = begin; e < end; ++e)
          rows.for_each_set(e, [&](const unsigned int size,
                                   const unsigned int row,
                                   const unsigned int coefficient) {
            const std::size_t r = rows.first_row(e) + row;
            double *const block =
                &of_sets[rows.first_coefficient(e) + coefficient];
            const auto first = cone;
            while (cone != all_cones.end() && cone->row == r)
              ++cone;
            if (size == 1)
              *block = coefficients[r];
            else if (first != cone)
              invert_set(first - all_cones.begin(), cone - first, weights,
                         with_curvature, block);
          });
      });
  coefficients = std::move(of_sets);
}

void ConicForces::multiply(std::vector<double> &r) const
{
  if (scalings.empty())
  {
    rows.multiply_by_blocks(coefficients, r);
    return;
  }
  const std::vector<double> d = r;
  for (std::size_t k = 0; k < r.size(); ++k)
    r[k] *= outside_cones[k];
  multiply_by_scalings(d, r);
}

/**
 * K d of all cones, where rounding of K would be more than what it gives in
 * some directions: B^-1 W (W B^-T d) of cones of friction, and by the
 * eigenvectors of K of circles, where those with the head given are
 * eta^2 (I - 2 w_t w_t^T / (1 + 2 |w_t|^2)).
 */
void ConicForces::multiply_by_scalings(const std::vector<double> &d,
                                       std::vector<double> &x) const
{
  for_each_cone([&](const std::size_t k) {
    const Cone &cone = all_cones[k];
    const QuadraticCone::Scaling &W = scalings[k];
    const double *const from = &d[cone.row];
    double *const to = &x[cone.row];
    if (cone.n_rows == 3)
    {
      const auto product = [&](const double *const v) {
        QuadraticCone::Vector result = W.times(W.times(
            {{v[0] / cone.b[0][0], v[1] / cone.b[1][1], v[2] / cone.b[2][2]}}));
        for (unsigned int i = 0; i < 3; ++i)
          result[i] /= cone.b[i][i];
        return result;
      };
      const QuadraticCone::Vector without = product(from);
      std::copy(without.begin(), without.end(), to);
      if (const double beta = of_their_bounds[k]; beta > 0.)
      {
        // By the formula of Sherman and Morrison.
        const double first[] = {1., 0., 0.};
        const QuadraticCone::Vector column = product(first);
        to[0] /= 1. + beta * column[0];
        for (unsigned int i = 1; i < 3; ++i)
          to[i] -= beta * column[i] * to[0];
      }
      return;
    }
    const double tail = QuadraticCone::size_of_tail(W.w);
    const double t[] = {tail > 0. ? W.w[1] / tail : 1.,
                        tail > 0. ? W.w[2] / tail : 0.};
    const double along = W.eta_squared * (t[0] * from[0] + t[1] * from[1]) /
                         (1. + 2. * tail * tail),
                 across = W.eta_squared * (t[0] * from[1] - t[1] * from[0]);
    to[0] = along * t[0] - across * t[1];
    to[1] = along * t[1] + across * t[0];
  });
}

std::vector<double>
ConicForces::multiplied_difference(const std::vector<double> &r,
                                   const std::vector<double> &u) const
{
  if (!scalings.empty())
  {
    // The digits of the difference count, not those of u.
    std::vector<double> x = r;
    rows.add_exact_jumps(u, x);
    multiply(x);
    return x;
  }
  std::vector<double> x = along(u);
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] = r[k] - x[k];
  multiply(x);
  for (const Cone &cone : all_cones)
  {
    const std::size_t k = cone.row;
    const double *const K = &coefficients[cone.coefficient];
    std::array<long double, 3> exact = {};
    for (unsigned int i = 0; i < cone.n_rows; ++i)
      exact[i] = r[k + i] + rows.exact_jump(k + i, u.data());
    for (unsigned int i = 0; i < cone.n_rows; ++i)
    {
      long double sum = K[cone.n_rows * i] * exact[0];
      for (unsigned int j = 1; j < cone.n_rows; ++j)
        sum += K[cone.n_rows * i + j] * exact[j];
      x[k + i] = static_cast<double>(sum);
    }
  }
  return x;
}

std::vector<double> ConicForces::product(const std::vector<double> &u) const
{
  std::vector<double> x = along(u);
  multiply(x);
  return on_bodies(x);
}

void ConicForces::set_border(std::vector<double> f)
{
  border = std::move(f);
  of_border = factor.solve(border, 1);
  work_of_border = dot(border, of_border);
}

/** Without a border this changes nothing. */
double ConicForces::clear_border_work(std::vector<double> &u,
                                      const double work) const
{
  if (border.empty())
    return 0.;
  const double alpha = (work - dot(border, u)) / work_of_border;
  add(u, alpha, of_border);
  return alpha;
}

ConicForces::Bordered ConicForces::solve(const std::vector<double> &right,
                                         const double work,
                                         const double enough,
                                         const unsigned int n_gradients) const
{
  Bordered now = {factor.solve(right, 1), 0.};
  now.alpha = clear_border_work(now.u, work);
  std::vector<double> left = right;
  add(left, -1., product(now.u));
  if (!border.empty())
    add(left, now.alpha, border);
  Bordered best = now;
  double least = largest_component(left), previous = 0.;
  std::vector<double> direction;
  unsigned int n_in_vain = 0;
  for (unsigned int k = 0;
       k < n_gradients && least > enough && n_in_vain < n_without_gain; ++k)
  {
    // What is left is that of the best alpha, so that it does not grow.
    std::vector<double> z = factor.solve(left, 1);
    if (const double more = clear_border_work(z, 0.); more != 0.)
    {
      now.alpha += more;
      add(left, more, border);
    }
    const double product_now = dot(left, z);
    if (direction.empty())
      direction = std::move(z);
    else
      for (std::size_t i = 0; i < z.size(); ++i)
        direction[i] = z[i] + product_now / previous * direction[i];
    previous = product_now;
    const std::vector<double> force = product(direction);
    const double energy = dot(direction, force);
    if (!(energy > 0.) || !(product_now > 0.))
      break;
    add(now.u, product_now / energy, direction);
    add(left, -product_now / energy, force);
    ++n_in_vain;
    if (const double size = largest_component(left); size < least)
    {
      best = now;
      least = size;
      n_in_vain = 0;
    }
  }
  return best;
}
} // namespace Voussoir
