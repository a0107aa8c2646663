// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/statics/conic/self_dual.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** The part of the way to the boundary that a step takes, and its limits. */
constexpr double usual_fraction = 0.99, largest_fraction = 1. - 1e-7;
/** The least product, over the mean of all. */
constexpr double least_relative_product = 1e-3;
constexpr double shortening = 0.9;
constexpr unsigned int n_shortenings = 30;

/**
 * Gondzio's corrections: how many, the steps that need none, what they gain. A
 * second one brings digits, but with many bounds it costs more than the steps
 * that it saves (measured, 10,000 random cells: 2 to 20 per cent of the time).
 */
constexpr unsigned int n_corrections = 2, n_corrections_of_many = 1;
constexpr std::size_t many_bounds = 20000;
constexpr double long_enough = 0.9, longer_trial = 0.3, least_gain = 0.03;
constexpr double outlying = 10.;

/** The residual at which the conjugate gradients of a step stop. */
constexpr double reduction_of_gradients = 1e-11, share_of_residual = 1e-3;
constexpr unsigned int n_self_dual_gradients = 12;
/** Where the refinement of the bordered system stops. */
constexpr double reduction_of_refinement = 1e-2, small_residual = 1e-13;
constexpr unsigned int n_refined_steps = 3;
} // namespace

bool SelfDual::prepare()
{
  ratio.resize(now.s.size());
  for (std::size_t b = 0; b < ratio.size(); ++b)
    ratio[b] = now.z[b] / now.s[b];
  stiffness = forces.inverse_sums(ratio);
  if (!forces.prepare(stiffness))
    return false;
  if (!loads.live.empty())
  {
    u_of_live = forces.solve(
        loads.live, reduction_of_gradients * largest_component(loads.live),
        n_self_dual_gradients);
    work_of_live = dot(loads.live, u_of_live);
  }

  // What a step depends on through tau, as a correction of the present point:
  // this keeps digits near the optimum.
  std::vector<double> of_bounds(ratio.size());
  for (std::size_t b = 0; b < ratio.size(); ++b)
    of_bounds[b] = (2. * now.z[b] - ratio[b] * residual.bounds[b]) / now.tau;
  std::vector<double> r1 = forces.of_rows(of_bounds);
  add(r1, -1. / now.tau, residual.multipliers);
  std::vector<double> balance = residual.balance;
  for (double &component : balance)
    component /= -now.tau;
  solve_bordered(r1, balance, -residual.live_work / now.tau, by_tau);
  by_tau.z = forces.at_bounds(by_tau.x);
  double curvature = 0.;
  for (std::size_t b = 0; b < ratio.size(); ++b)
  {
    by_tau.z[b] = ratio[b] * by_tau.z[b] +
                  (ratio[b] * residual.bounds[b] - now.z[b]) / now.tau;
    curvature += by_tau.z[b] * by_tau.z[b] / ratio[b];
  }
  add(by_tau.x, 1. / now.tau, now.x);
  add(by_tau.u, 1. / now.tau, now.u);
  by_tau.alpha += now.alpha / now.tau;
  slope_of_tau = -now.kappa / now.tau - curvature;
  return true;
}

/**
 * Find x, u and alpha with
 *
 *     x / stiffness + A^T u = r1,  A x + alpha f_1 = balance,
 *     f_1 . u = live_work.
 */
void SelfDual::solve_bordered(const std::vector<double> &r1,
                              const std::vector<double> &balance,
                              const double live_work,
                              Variables &found)
{
  std::vector<double> k_r1 = r1;
  for (std::size_t k = 0; k < k_r1.size(); ++k)
    k_r1[k] *= stiffness[k];
  std::vector<double> right = forces.on_bodies(k_r1);
  add(right, -1., balance);
  // What a step leaves undone is left for the next one.
  const double enough =
      std::max(small_residual * size_of_loads * now.tau,
               share_of_residual * largest_component(residual.balance));
  found.u = forces.solve(
      right,
      std::max(reduction_of_gradients * largest_component(right), enough),
      n_self_dual_gradients);
  found.alpha = 0.;
  if (!loads.live.empty())
  {
    found.alpha = (live_work - dot(loads.live, found.u)) / work_of_live;
    add(found.u, found.alpha, u_of_live);
    for (unsigned int n = 0; n < n_refined_steps; ++n)
    {
      std::vector<double> left = right;
      add(left, found.alpha, loads.live);
      add(left, -1., forces.product(found.u));
      const double missing = live_work - dot(loads.live, found.u);
      if (largest_component(left) < enough &&
          std::abs(missing) < small_residual)
        break;
      const std::vector<double> du =
          forces.solve(left, reduction_of_refinement * largest_component(left),
                       n_self_dual_gradients);
      const double more = (missing - dot(loads.live, du)) / work_of_live;
      add(found.u, 1., du);
      add(found.u, more, u_of_live);
      found.alpha += more;
    }
  }
  found.x = k_r1;
  const std::vector<double> along = forces.along(found.u);
  for (std::size_t k = 0; k < along.size(); ++k)
    found.x[k] -= stiffness[k] * along[k];
}

/**
 * The step to where @p part of the residuals is gone, and the products less by
 * @p products.
 */
SelfDual::Step SelfDual::direction(const std::vector<double> &products,
                                   const double last_product,
                                   const double part)
{
  std::vector<double> g(products.size());
  for (std::size_t b = 0; b < g.size(); ++b)
    g[b] = (part * now.z[b] * residual.bounds[b] - products[b]) / now.s[b];
  std::vector<double> r1 = forces.of_rows(g);
  for (std::size_t k = 0; k < r1.size(); ++k)
    r1[k] = -r1[k] - part * residual.multipliers[k];
  std::vector<double> balance = residual.balance;
  for (double &component : balance)
    component *= -part;
  Step step;
  solve_bordered(r1, balance, -part * residual.live_work, step);
  step.z = forces.at_bounds(step.x);
  double h_z = 0.;
  for (std::size_t b = 0; b < g.size(); ++b)
  {
    step.z[b] = g[b] + ratio[b] * step.z[b];
    h_z += forces.bounds()[b].limit * step.z[b];
  }
  step.tau = (-part * residual.gap + last_product / now.tau +
              loads.sense * step.alpha + dot(loads.dead, step.u) - h_z) /
             slope_of_tau;
  add(step.x, step.tau, by_tau.x);
  add(step.u, step.tau, by_tau.u);
  add(step.z, step.tau, by_tau.z);
  step.alpha += step.tau * by_tau.alpha;
  step.s = forces.at_bounds(step.x);
  for (std::size_t b = 0; b < g.size(); ++b)
    step.s[b] = -part * residual.bounds[b] - step.s[b] +
                step.tau * forces.bounds()[b].limit;
  step.kappa = (-last_product - now.kappa * step.tau) / now.tau;
  return step;
}

/** The part of a step to where something vanishes, at most one. */
double SelfDual::longest(const Step &step) const
{
  double fastest = std::max({1., -step.tau / now.tau, -step.kappa / now.kappa});
  for (std::size_t b = 0; b < now.s.size(); ++b)
    fastest = std::max({fastest, -step.s[b] / now.s[b], -step.z[b] / now.z[b]});
  return 1. / fastest;
}

void SelfDual::find_products(const Step &step,
                             const double length,
                             std::vector<double> &products,
                             double &last) const
{
  products.resize(now.s.size());
  for (std::size_t b = 0; b < now.s.size(); ++b)
    products[b] =
        (now.s[b] + length * step.s[b]) * (now.z[b] + length * step.z[b]);
  last = (now.tau + length * step.tau) * (now.kappa + length * step.kappa);
}

/** Shorten a step until no product is far below the mean. */
double SelfDual::keep_products_near(const Step &step, double length) const
{
  std::vector<double> products;
  double last;
  for (unsigned int n = 0; n < n_shortenings; ++n, length *= shortening)
  {
    find_products(step, length, products, last);
    double sum = last, least = last;
    for (const double product : products)
    {
      sum += product;
      least = std::min(least, product);
    }
    if (least >= least_relative_product * sum / (products.size() + 1.))
      break;
  }
  return length;
}

SelfDual::State SelfDual::step()
{
  const InvalidOperationsAllowed allowed;
  if (!prepare())
    return State::stalled;
  const double mean = mean_product();
  std::vector<double> products(now.s.size()), trial;
  for (std::size_t b = 0; b < products.size(); ++b)
    products[b] = now.s[b] * now.z[b];
  double last = now.tau * now.kappa, trial_last;
  Step best = direction(products, last, 1.);
  double length = longest(best);

  find_products(best, length, trial, trial_last);
  double sum = trial_last;
  for (const double product : trial)
    sum += product;
  const double left = sum / (trial.size() + 1.) / mean;
  const double centring =
      length > 0.1 ? std::pow(std::min(1., std::max(left, 1e-10)), 3.)
                   : 1. - length;
  const double target = centring * mean;
  for (std::size_t b = 0; b < products.size(); ++b)
    products[b] += best.s[b] * best.z[b] - target;
  last += best.tau * best.kappa - target;
  best = direction(products, last, 1. - centring);
  length = longest(best);

  const unsigned int n_most =
      products.size() < many_bounds ? n_corrections : n_corrections_of_many;
  for (unsigned int n = 0; n < n_most && length <= long_enough; ++n)
  {
    // Bring products that a longer step would leave far from the target back.
    find_products(best, std::min(1., length + longer_trial), trial, trial_last);
    const auto correction = [&](const double product) {
      return std::max(
          std::clamp(product, target / outlying, target * outlying) - product,
          -outlying * target);
    };
    for (std::size_t b = 0; b < trial.size(); ++b)
      trial[b] = products[b] - correction(trial[b]);
    trial_last = last - correction(trial_last);
    const Step other = direction(trial, trial_last, 1. - centring);
    const double other_length = longest(other);
    if (!(other_length >= length + least_gain))
      break;
    best = other;
    length = other_length;
    products = trial;
    last = trial_last;
  }
  if (length < 1.)
    length *= std::min(std::max(usual_fraction, 1. - mean), largest_fraction);
  length = keep_products_near(best, length);
  if (!std::isfinite(length * (best.tau + best.kappa + best.alpha)))
    return State::stalled;

  ++iterations;
  add(now.x, length, best.x);
  add(now.u, length, best.u);
  add(now.s, length, best.s);
  add(now.z, length, best.z);
  now.alpha += length * best.alpha;
  now.tau += length * best.tau;
  now.kappa += length * best.kappa;
  return judge();
}
} // namespace Voussoir
