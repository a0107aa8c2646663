// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/statics/conic/self_dual.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Voussoir
{
namespace
{
/** The part of the way to the boundary that a step takes, and its limits. */
constexpr double usual_fraction = 0.99, largest_fraction = 1. - 1e-7;
/**
 * The least product, over the mean of all: the usual one, of cones, and with a
 * quadratic cost near its optimum.
 */
constexpr double least_relative_product = 1e-3, least_of_cones = 0.05,
                 least_near_optimum = 1e-5, near_optimum = 1e-5;
constexpr double shortening = 0.9, shortening_of_curved = 0.97;
constexpr unsigned int n_shortenings = 30, n_shortenings_of_curved = 60;

/**
 * Gondzio's corrections: how many, the steps that need none, what they gain. A
 * second one brings digits, but with many bounds it costs more than the steps
 * that it saves (measured, 10,000 random cells: 2 to 20 per cent of the time),
 * but for short steps with a quadratic cost (100,000 random cells near their
 * limit: 29 steps instead of 42).
 */
constexpr unsigned int n_corrections = 2, n_corrections_of_many = 1;
constexpr std::size_t many_bounds = 20000;
constexpr double short_of_many = 0.6;
constexpr double long_enough = 0.9, longer_trial = 0.3, least_gain = 0.03;
constexpr double outlying = 10.;
} // namespace

/** The part of a step to where something vanishes, at most one. */
double SelfDual::longest(const Step &step) const
{
  double fastest = std::max({1., -step.tau / now.tau, -step.kappa / now.kappa});
  for (std::size_t b = 0; b < n_bounds; ++b)
    fastest = std::max({fastest, -step.s[b] / now.s[b], -step.z[b] / now.z[b]});
  fastest = forces.largest_of_cones(fastest, [&](const std::size_t k) {
    const ScaledStep &of = step.scaled[k];
    return std::max({0., QuadraticCone::inverse_of_longest(lambda[k], of.s),
                     QuadraticCone::inverse_of_longest(lambda[k], of.z)});
  });
  return 1. / fastest;
}

void SelfDual::find_products(const Step &step,
                             const double length,
                             std::vector<double> &products,
                             double &last) const
{
  products.resize(now.s.size());
  for (std::size_t b = 0; b < n_bounds; ++b)
    products[b] =
        (now.s[b] + length * step.s[b]) * (now.z[b] + length * step.z[b]);
  forces.for_each_cone([&](const std::size_t k) {
    QuadraticCone::Vector s = step.scaled[k].s, z = step.scaled[k].z;
    for (unsigned int i = 0; i < 3; ++i)
    {
      s[i] = lambda[k][i] + length * s[i];
      z[i] = lambda[k][i] + length * z[i];
    }
    forces.set_cone(products, k, QuadraticCone::product(s, z));
  });
  last = (now.tau + length * step.tau) * (now.kappa + length * step.kappa);
}

/** Add what the linearisation leaves out of @p step, less @p target. */
void SelfDual::add_second_order(const Step &step,
                                const double target,
                                std::vector<double> &products) const
{
  for (std::size_t b = 0; b < n_bounds; ++b)
    products[b] += step.s[b] * step.z[b] - target;
  forces.for_each_cone([&](const std::size_t k) {
    const QuadraticCone::Vector of_step =
        QuadraticCone::product(step.scaled[k].s, step.scaled[k].z);
    QuadraticCone::Vector of_cone = forces.of_cone(products, k);
    for (unsigned int i = 0; i < 3; ++i)
      of_cone[i] += of_step[i];
    of_cone[0] -= target;
    forces.set_cone(products, k, of_cone);
  });
}

namespace
{
/** What brings a product that is far from the target back. */
double correction(const double product, const double target)
{
  return std::max(std::clamp(product, target / outlying, target * outlying) -
                      product,
                  -outlying * target);
}
} // namespace

/** Replace @p products by what brings them back to @p target. */
void SelfDual::pull_back(const double target,
                         std::vector<double> &products) const
{
  for (std::size_t b = 0; b < n_bounds; ++b)
    products[b] = correction(products[b], target);
  forces.for_each_cone([&](const std::size_t k) {
    const QuadraticCone::Vector of_cone = forces.of_cone(products, k);
    std::array<double, 2> values = QuadraticCone::eigenvalues(of_cone);
    for (double &value : values)
      value = correction(value, target);
    forces.set_cone(products, k,
                    QuadraticCone::with_eigenvalues(of_cone, values));
  });
}

/**
 * The least product after a part of a step, over the mean of all and what it
 * may be.
 */
double SelfDual::least_product(const Step &step, const double length) const
{
  const auto after = [&](const double v, const double of_step) {
    return v + length * of_step;
  };
  const double last = after(now.tau, step.tau) * after(now.kappa, step.kappa);
  double sum = last, least = last;
  for (std::size_t b = 0; b < n_bounds; ++b)
  {
    const double product =
        after(now.s[b], step.s[b]) * after(now.z[b], step.z[b]);
    sum += product;
    least = std::min(least, product);
  }
  const std::size_t size = light_items_of_a_chunk;
  std::vector<double> sums(n_chunks(lambda.size(), size), 0.);
  const double least_of_all_cones = -forces.largest_of_cones(
      -std::numeric_limits<double>::infinity(), [&](const std::size_t k) {
        QuadraticCone::Vector s = forces.of_cone(now.s, k),
                              z = forces.of_cone(now.z, k);
        const QuadraticCone::Vector of_s = forces.of_cone(step.s, k),
                                    of_z = forces.of_cone(step.z, k);
        for (unsigned int i = 0; i < 3; ++i)
        {
          s[i] = after(s[i], of_s[i]);
          z[i] = after(z[i], of_z[i]);
        }
        sums[k / size] += s[0] * z[0] + s[1] * z[1] + s[2] * z[2];
        return QuadraticCone::contains(s) && QuadraticCone::contains(z)
                   ? -std::sqrt(QuadraticCone::det(s) * QuadraticCone::det(z))
                   : 0.;
      });
  sum = std::accumulate(sums.begin(), sums.end(), sum);
  const double mean = sum / (n_bounds + lambda.size() + 1.);
  const double may_be = program.has_curvature && error < near_optimum
                            ? least_near_optimum
                            : least_relative_product;
  const double of_bounds = least / (may_be * mean);
  return lambda.empty() ? of_bounds
                        : std::min(of_bounds, least_of_all_cones /
                                                  (least_of_cones * mean));
}

/** Shorten a step until no product is far below the mean. */
double SelfDual::keep_products_near(const Step &step, double length) const
{
  const unsigned int n_most =
      program.has_curvature ? n_shortenings_of_curved : n_shortenings;
  for (unsigned int n = 0; n < n_most && !(least_product(step, length) >= 1.);
       ++n)
    length *= program.has_curvature ? shortening_of_curved : shortening;
  return length;
}

SelfDual::State SelfDual::step()
{
  const InvalidOperationsAllowed allowed;
  if (!prepare())
    return State::stalled;
  const double mean = mean_product();
  std::vector<double> products, trial;
  double last, trial_last;
  products.resize(now.s.size());
  for (std::size_t b = 0; b < n_bounds; ++b)
    products[b] = now.s[b] * now.z[b];
  for (std::size_t k = 0; k < lambda.size(); ++k)
    forces.set_cone(products, k, QuadraticCone::product(lambda[k], lambda[k]));
  last = now.tau * now.kappa;
  Step best = predictor(products, last);
  double length = longest(best);

  find_products(best, length, trial, trial_last);
  double sum = trial_last;
  for (std::size_t b = 0; b < n_bounds; ++b)
    sum += trial[b];
  for (std::size_t k = 0; k < lambda.size(); ++k)
    sum += forces.of_cone(trial, k)[0];
  const double left = sum / (n_bounds + lambda.size() + 1.) / mean;
  const double centring =
      length > 0.1 ? std::pow(std::min(1., std::max(left, 1e-10)), 3.)
                   : 1. - length;
  const double target = centring * mean;
  add_second_order(best, target, products);
  last += best.tau * best.kappa - target;
  best = direction(products, last, 1. - centring);
  length = longest(best);

  const unsigned int n_most =
      products.size() < many_bounds ||
              (program.has_curvature && length < short_of_many)
          ? n_corrections
          : n_corrections_of_many;
  for (unsigned int n = 0; n < n_most && length <= long_enough; ++n)
  {
    // Bring products that a longer step would leave far from the target back.
    find_products(best, std::min(1., length + longer_trial), trial, trial_last);
    pull_back(target, trial);
    for (std::size_t b = 0; b < trial.size(); ++b)
      trial[b] = products[b] - trial[b];
    trial_last = last - correction(trial_last, target);
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
  if (!forces.of().is_plane())
    now.s = slacks_of_forces();
  return judge();
}
} // namespace Voussoir
