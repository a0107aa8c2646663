// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/conic/self_dual.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/**
 * The weight of |x - now|^2 / 2 where a verdict is asked for. Where no row is
 * near its limit K would grow without end beside that of rows that slide, and
 * with several mechanisms at once, as of a dry pile, the systems would lose all
 * digits; the optimum is the same. Far from it rays must grow freely. A factor
 * has one mechanism, and does with half of the steps without it (measured, a
 * dry wall of 10,000 bricks: 73 instead of 182).
 */
constexpr double proximal_weight = 1e-8, near_optimum_of_forces = 1e-4;

/** The residual at which the conjugate gradients of a step stop. */
constexpr double reduction_of_gradients = 1e-11, share_of_residual = 1e-3;
constexpr unsigned int n_self_dual_gradients = 12;
/** Where the refinement of the bordered system stops. */
constexpr double reduction_of_refinement = 1e-2, small_residual = 1e-13;
constexpr unsigned int n_refined_steps = 3, n_refined_cones = 2;

/**
 * The z = W^-2 B x of a circle or a cone of friction, by B^T z: of a circle the
 * head is what makes that of W^2 z vanish.
 */
QuadraticCone::Vector multiplier_of(const ConicForces::Cone &cone,
                                    const QuadraticCone::Scaling &scaling,
                                    const std::array<double, 3> &of_z)
{
  if (cone.n_rows == 3)
    return {{of_z[0] / cone.b[0][0], of_z[1] / cone.b[1][1],
             of_z[2] / cone.b[2][2]}};
  const QuadraticCone::Vector &w = scaling.w;
  QuadraticCone::Vector z = {
      {0., of_z[0] / cone.b[1][0], of_z[1] / cone.b[2][1]}};
  z[0] = -2. * w[0] * (w[1] * z[1] + w[2] * z[2]) / (2. * w[0] * w[0] - 1.);
  return z;
}
} // namespace

/** Find the ratios of the bounds, and the scaling of the cones. */
void SelfDual::find_scaling()
{
  weights.of_bounds.resize(n_bounds);
  for (std::size_t b = 0; b < n_bounds; ++b)
    weights.of_bounds[b] = now.z[b] / now.s[b];
  weights.of_cones.resize(forces.cones().size());
  lambda.resize(forces.cones().size());
  forces.for_each_cone([&](const std::size_t k) {
    const QuadraticCone::Vector z = forces.of_cone(now.z, k);
    weights.of_cones[k] =
        QuadraticCone::Scaling::of(forces.of_cone(now.s, k), z);
    lambda[k] = weights.of_cones[k].times(z);
  });
}

/** W^-2 times what has a number for each slack. */
std::vector<double> SelfDual::over_squares(const std::vector<double> &v) const
{
  std::vector<double> result(v.size());
  for (std::size_t b = 0; b < n_bounds; ++b)
    result[b] = weights.of_bounds[b] * v[b];
  forces.for_each_cone([&](const std::size_t k) {
    forces.set_cone(result, k,
                    weights.of_cones[k].over_square(forces.of_cone(v, k)));
  });
  return result;
}

/**
 * W^-2 B x of a solution of solve_bordered(). In a cone this loses the digits
 * of what is balanced there, which its residual brings back.
 */
std::vector<double> SelfDual::multipliers_of(const std::vector<double> &r1,
                                             const Variables &found) const
{
  std::vector<double> z = over_squares(forces.at_slacks(found.x));
  if (lambda.empty())
    return z;
  const std::vector<double> along = forces.along(found.u);
  if (!forces.of().is_plane())
  {
    // B is invertible on the rows of each cone.
    forces.for_each_cone([&](const std::size_t k) {
      const ConicForces::Cone &cone = forces.cones()[k];
      std::array<double, 3> of_z = {};
      for (unsigned int i = 0; i < cone.n_rows; ++i)
      {
        const std::size_t r = cone.row + i;
        of_z[i] = r1[r] - along[r];
        if (program.has_curvature)
          of_z[i] -= forces.curvature()[r] * found.x[r];
      }
      if (cone.bound >= 0)
        of_z[0] -= weights.of_bounds[cone.bound] * found.x[cone.row];
      forces.set_cone(z, k, multiplier_of(cone, weights.of_cones[k], of_z));
    });
    return z;
  }
  for (unsigned int n = 0; n < n_refined_cones; ++n)
  {
    const std::vector<double> of_z = forces.of_rows(z);
    std::vector<double> left(r1.size(), 0.);
    for (const ConicForces::Cone &cone : forces.cones())
      for (std::size_t k = cone.row; k < cone.row + cone.n_rows; ++k)
      {
        left[k] = r1[k] - along[k] - of_z[k];
        if (program.has_curvature)
          left[k] -= forces.curvature()[k] * found.x[k];
      }
    forces.multiply(left);
    add(z, 1., over_squares(forces.at_slacks(left)));
  }
  return z;
}

bool SelfDual::prepare()
{
  find_scaling();
  const bool is_proximal = program.is_verdict && error < near_optimum_of_forces;
  if (!forces.prepare(weights, program.has_curvature,
                      is_proximal ? proximal_weight : 0.))
    return false;
  if (!program.live.empty())
    forces.set_border(program.live);
  return true;
}

/**
 * Find what a step depends on through tau, as a correction of the present
 * point: this keeps digits near the optimum.
 */
void SelfDual::find_by_tau()
{
  const std::vector<double> of_residual = over_squares(residual.bounds);
  std::vector<double> of_slacks(now.s.size());
  for (std::size_t b = 0; b < of_slacks.size(); ++b)
    of_slacks[b] = (2. * now.z[b] - of_residual[b]) / now.tau;
  std::vector<double> r1 = forces.of_rows(of_slacks);
  add(r1, -1. / now.tau, residual.multipliers);
  std::vector<double> balance = residual.balance;
  for (double &component : balance)
    component /= -now.tau;
  solve_bordered(r1, balance, -residual.live_work / now.tau,
                 reduction_of_gradients, by_tau);
  by_tau.z = multipliers_of(r1, by_tau);
  for (std::size_t b = 0; b < of_slacks.size(); ++b)
    by_tau.z[b] += (of_residual[b] - now.z[b]) / now.tau;
  double curvature = curvature_of(by_tau.x, by_tau.x);
  for (std::size_t b = 0; b < n_bounds; ++b)
    curvature += by_tau.z[b] * by_tau.z[b] / weights.of_bounds[b];
  for (std::size_t k = 0; k < lambda.size(); ++k)
  {
    const QuadraticCone::Vector scaled =
        weights.of_cones[k].times(forces.of_cone(by_tau.z, k));
    curvature += QuadraticCone::product(scaled, scaled)[0];
  }
  add(by_tau.x, 1. / now.tau, now.x);
  add(by_tau.u, 1. / now.tau, now.u);
  by_tau.alpha += now.alpha / now.tau;
  slope_of_tau = -now.kappa / now.tau - curvature;
}

/**
 * Find x, u and alpha with
 *
 *     K^-1 x + A^T u = r1,  A x + alpha f_1 = balance,
 *     f_1 . u = live_work.
 */
void SelfDual::solve_bordered(const std::vector<double> &r1,
                              const std::vector<double> &balance,
                              const double live_work,
                              const double reduction,
                              Variables &found) const
{
  std::vector<double> k_r1 = r1;
  forces.multiply(k_r1);
  std::vector<double> right = forces.on_bodies(k_r1);
  add(right, -1., balance);
  // What a step leaves undone is left for the next one.
  const double enough =
      std::max(small_residual * size_of_loads * now.tau,
               share_of_residual * largest_component(residual.balance));
  ConicForces::Bordered solution = forces.solve(
      right, live_work, std::max(reduction * largest_component(right), enough),
      n_self_dual_gradients);
  found.u = std::move(solution.u);
  found.alpha = solution.alpha;
  found.x = forces.multiplied_difference(r1, found.u);
  balance_forces(balance, live_work, enough, found);
}

/**
 * Refine a solution where K is so large that u has not the digits of x: its
 * changes have them.
 */
void SelfDual::balance_forces(const std::vector<double> &balance,
                              const double live_work,
                              const double enough,
                              Variables &found) const
{
  for (unsigned int n = 0; n < n_refined_steps; ++n)
  {
    std::vector<double> left = forces.on_bodies(found.x);
    add(left, -1., balance);
    double missing = 0.;
    if (!program.live.empty())
    {
      add(left, found.alpha, program.live);
      missing = live_work - dot(program.live, found.u);
    }
    if (largest_component(left) < enough && std::abs(missing) < small_residual)
      break;
    const ConicForces::Bordered more = forces.solve(
        left, missing, reduction_of_refinement * largest_component(left),
        n_self_dual_gradients);
    add(found.u, 1., more.u);
    found.alpha += more.alpha;
    std::vector<double> dx = forces.along(more.u);
    forces.multiply(dx);
    add(found.x, -1., dx);
  }
}

/**
 * The step to where @p part of the residuals is gone, and the products less by
 * @p products; without what tau adds to it.
 */
SelfDual::Step SelfDual::change(const std::vector<double> &products,
                                const double part,
                                const double reduction) const
{
  std::vector<double> g(products.size());
  for (std::size_t b = 0; b < n_bounds; ++b)
    g[b] = (part * now.z[b] * residual.bounds[b] - products[b]) / now.s[b];
  forces.for_each_cone([&](const std::size_t k) {
    const QuadraticCone::Scaling &W = weights.of_cones[k];
    const QuadraticCone::Vector of_residual =
        W.over_square(forces.of_cone(residual.bounds, k));
    QuadraticCone::Vector of_cone =
        W.over(QuadraticCone::quotient(lambda[k], forces.of_cone(products, k)));
    for (unsigned int i = 0; i < 3; ++i)
      of_cone[i] = part * of_residual[i] - of_cone[i];
    forces.set_cone(g, k, of_cone);
  });
  std::vector<double> r1 = forces.of_rows(g);
  for (std::size_t k = 0; k < r1.size(); ++k)
    r1[k] = -r1[k] - part * residual.multipliers[k];
  std::vector<double> balance = residual.balance;
  for (double &component : balance)
    component *= -part;
  Step step;
  solve_bordered(r1, balance, -part * residual.live_work, reduction, step);
  step.z = multipliers_of(r1, step);
  add(step.z, 1., g);
  return step;
}

/** Add to the change() with the same products what tau adds, and find the rest.
 */
void SelfDual::complete(const std::vector<double> &products,
                        const double last_product,
                        const double part,
                        Step &step) const
{
  double h_z = 0.;
  for (std::size_t b = 0; b < limits.size(); ++b)
    h_z += limits[b] * step.z[b];
  double to_gap = -part * residual.gap + last_product / now.tau +
                  program.sense * step.alpha + dot(program.dead, step.u) - h_z;
  if (program.has_curvature)
    to_gap -= 2. / now.tau * curvature_of(now.x, step.x);
  if (!program.cost.empty())
    to_gap -= dot(program.cost, step.x);
  step.tau = to_gap / slope_of_tau;
  add(step.x, step.tau, by_tau.x);
  add(step.u, step.tau, by_tau.u);
  add(step.z, step.tau, by_tau.z);
  step.alpha += step.tau * by_tau.alpha;
  step.s = forces.at_slacks(step.x);
  for (std::size_t b = 0; b < limits.size(); ++b)
    step.s[b] = -part * residual.bounds[b] - step.s[b] + step.tau * limits[b];
  step.kappa = (-last_product - now.kappa * step.tau) / now.tau;
  step.scaled.resize(lambda.size());
  forces.for_each_cone([&](const std::size_t k) {
    const QuadraticCone::Scaling &W = weights.of_cones[k];
    ScaledStep &scaled = step.scaled[k];
    scaled.z = W.times(forces.of_cone(step.z, k));
    scaled.s = W.over(forces.of_cone(step.s, k));
    if (forces.of().is_plane())
      return;
    // What the equation of the products says has more digits.
    scaled.s = QuadraticCone::quotient(lambda[k], forces.of_cone(products, k));
    for (unsigned int i = 0; i < 3; ++i)
      scaled.s[i] = -scaled.s[i] - scaled.z[i];
  });
}

SelfDual::Step SelfDual::direction(const std::vector<double> &products,
                                   const double last_product,
                                   const double part) const
{
  Step step = change(products, part, reduction_of_gradients);
  complete(products, last_product, part, step);
  return step;
}

/** The step to where all residuals and products vanish, and by_tau. */
SelfDual::Step SelfDual::predictor(const std::vector<double> &products,
                                   const double last_product)
{
  Step step;
  for_chunks(2, 1, [&](const std::size_t k, std::size_t, std::size_t) {
    if (k == 0)
      find_by_tau();
    else
      step = change(products, 1., reduction_of_gradients);
  });
  complete(products, last_product, 1., step);
  return step;
}
} // namespace Voussoir
