// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/statics/factor_bounds.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
constexpr unsigned int n_rounds = 8;
/** The part of the way to a bound that a correction may take. */
constexpr double fraction_to_bound = 0.9;
/** Errors, relative to the loads and to the displacement, that are rounding. */
constexpr double rounding_of_balance = 1e-15, rounding_of_motion = 1e-16;
/** The stopping criteria of the conjugate gradients. */
constexpr double reduction = 1e-15;
constexpr unsigned int n_gradients = 15;

/**
 * Solve S y + f_1 alpha = right, f_1 . y = work, with the matrix S that is
 * prepared; without live loads S y = right.
 */
std::vector<double> solve(BoundedForces &forces,
                          const std::vector<double> &live,
                          const std::vector<double> &right,
                          const double work,
                          double &alpha)
{
  std::vector<double> y = forces.solve(right, reduction, n_gradients);
  alpha = 0.;
  if (live.empty())
    return y;
  const std::vector<double> of_live =
      forces.solve(live, reduction, n_gradients);
  alpha = (dot(live, y) - work) / dot(live, of_live);
  add(y, -alpha, of_live);
  return y;
}

std::vector<double> missing(const BoundedForces &forces,
                            const SelfDual::Loads &loads,
                            const FactorState &state)
{
  std::vector<double> left = forces.on_bodies(state.x);
  add(left, 1., loads.dead);
  if (!loads.live.empty())
    add(left, state.alpha, loads.live);
  for (double &component : left)
    component = -component;
  return left;
}

/** The distance of each force from its nearest bound; zero if it has none. */
std::vector<double> distances(const BoundedForces &forces,
                              const std::vector<double> &x)
{
  std::vector<double> distance(x.size(), -1.);
  for (const BoundedForces::Bound &bound : forces.bounds())
  {
    const double d = bound.limit - bound.sign * x[bound.row];
    double &least = distance[bound.row];
    least = least < 0. ? d : std::min(least, d);
  }
  for (double &d : distance)
    d = std::max(d, 0.);
  return distance;
}

/** Forces strictly within their bounds, in proportion to the slacks. */
std::vector<double> within_bounds(const BoundedForces &forces,
                                  const std::vector<double> &slack)
{
  std::vector<double> x(forces.of().n_all_rows(), 0.);
  const auto &bounds = forces.bounds();
  for (std::size_t b = 0; b < bounds.size(); ++b)
    if (b + 1 < bounds.size() && bounds[b + 1].row == bounds[b].row)
    {
      x[bounds[b].row] =
          (bounds[b].limit * slack[b + 1] - bounds[b + 1].limit * slack[b]) /
          (slack[b + 1] + slack[b]);
      ++b;
    }
    else
      x[bounds[b].row] = bounds[b].limit - slack[b];
  return x;
}
} // namespace

FactorState state_near(BoundedForces &forces,
                       const SelfDual::Loads &loads,
                       const SelfDual::Point &point,
                       const std::optional<FactorState> &anchor,
                       const double share)
{
  const InvalidOperationsAllowed allowed;
  const double size =
      std::max(largest_component(loads.dead), largest_component(loads.live));
  FactorState best = {within_bounds(forces, point.s), point.alpha, 0.};
  if (anchor)
  {
    for (std::size_t k = 0; k < best.x.size(); ++k)
      best.x[k] += share * (anchor->x[k] - best.x[k]);
    best.alpha += share * (anchor->alpha - best.alpha);
  }
  best.residual = largest_component(missing(forces, loads, best)) / size;
  FactorState trial = best;
  for (unsigned int n = 0; n < n_rounds && best.residual > rounding_of_balance;
       ++n)
  {
    const std::vector<double> distance = distances(forces, trial.x);
    // Squares keep all forces within their bounds in the first step; with an
    // anchor there is room, and less is lost to rounding.
    std::vector<double> weights = distance;
    if (!anchor)
      for (double &d : weights)
        d *= d;
    if (!forces.prepare(weights))
      break;
    double alpha;
    std::vector<double> dx = forces.along(
        solve(forces, loads.live, missing(forces, loads, trial), 0., alpha));
    double fastest = 0.;
    for (std::size_t k = 0; k < dx.size(); ++k)
      if (distance[k] > 0.)
      {
        dx[k] *= weights[k];
        fastest = std::max(fastest, std::abs(dx[k]) / distance[k]);
      }
      else
        dx[k] = 0.;
    const double part =
        fastest > fraction_to_bound ? fraction_to_bound / fastest : 1.;
    add(trial.x, part, dx);
    trial.alpha += part * alpha;
    trial.residual = largest_component(missing(forces, loads, trial)) / size;
    if (trial.residual < best.residual)
      best = trial;
  }
  return best;
}

std::vector<double> mechanism_near(BoundedForces &forces,
                                   const SelfDual::Loads &loads,
                                   const SelfDual::Point &point)
{
  const InvalidOperationsAllowed allowed;
  std::vector<double> u = point.u, z = point.z;
  for (unsigned int n = 0; n < n_rounds; ++n)
  {
    std::vector<double> left = forces.along(u);
    add(left, 1., forces.of_rows(z));
    const double work =
        loads.live.empty() ? 0. : loads.sense - dot(loads.live, u);
    if (std::max(largest_component(left), std::abs(work)) <=
        rounding_of_motion * largest_component(u))
      break;
    std::vector<double> squares = z;
    for (double &component : squares)
      component *= component;
    const std::vector<double> k = forces.inverse_sums(squares);
    if (!forces.prepare(k))
      break;
    for (std::size_t r = 0; r < left.size(); ++r)
      left[r] *= -k[r];
    double alpha;
    const std::vector<double> du =
        solve(forces, loads.live, forces.on_bodies(left), work, alpha);
    std::vector<double> change = forces.along(du);
    for (std::size_t r = 0; r < left.size(); ++r)
      change[r] = left[r] - k[r] * change[r];
    std::vector<double> dz = forces.at_bounds(change);
    double fastest = 0.;
    for (std::size_t b = 0; b < dz.size(); ++b)
    {
      dz[b] *= squares[b];
      fastest = std::max(fastest, -dz[b] / z[b]);
    }
    const double part =
        fastest > fraction_to_bound ? fraction_to_bound / fastest : 1.;
    add(u, part, du);
    add(z, part, dz);
  }
  return u;
}
} // namespace Voussoir
