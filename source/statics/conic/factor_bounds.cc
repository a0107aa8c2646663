// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/statics/conic/factor_bounds.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** The rounds of a correction, and those that may bring nothing. */
constexpr unsigned int n_bound_rounds = 8, n_rounds_without_gain = 2;
/** The part of the way to a bound that a correction may take. */
constexpr double fraction_to_bound = 0.9;
/** Errors, relative to the loads and to the displacement, that are rounding. */
constexpr double rounding_of_bound = 1e-14, rounding_of_motion = 1e-14;
/** The stopping criteria of the conjugate gradients. */
constexpr double reduction_of_imbalance = 1e-15;
constexpr unsigned int n_bound_gradients = 15;

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
  const auto solve_for = [&](const std::vector<double> &load) {
    return forces.solve(load, reduction_of_imbalance * largest_component(load),
                        n_bound_gradients);
  };
  std::vector<double> y = solve_for(right);
  alpha = 0.;
  if (live.empty())
    return y;
  const std::vector<double> of_live = solve_for(live);
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

/** Counts the rounds of a correction. */
class Patience
{
public:
  bool lasts() const
  {
    return n < n_bound_rounds && n_in_vain < n_rounds_without_gain;
  }
  void see(const double error, const double least)
  {
    ++n;
    n_in_vain = error < least ? 0 : n_in_vain + 1;
  }

private:
  unsigned int n = 0, n_in_vain = 0;
};

/** Go a share of the way from x to y. */
void towards(std::vector<double> &x,
             const double share,
             const std::vector<double> &y)
{
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] += share * (y[k] - x[k]);
}

/** The largest closing where a force has no limit, over the displacement. */
double closing_of(const BoundedForces &forces, const std::vector<double> &u)
{
  const std::vector<double> jumps = forces.along(u);
  const auto &bounds = forces.bounds();
  double closing = 0.;
  for (std::size_t b = 0; b < bounds.size(); ++b)
    if (b + 1 < bounds.size() && bounds[b + 1].row == bounds[b].row)
      ++b;
    else
      closing = std::max(closing, bounds[b].sign * jumps[bounds[b].row]);
  return closing / largest_component(u);
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
  const double dead = largest_component(loads.dead),
               live = largest_component(loads.live);
  const auto residual = [&](const FactorState &state) {
    return largest_component(missing(forces, loads, state)) /
           std::max(dead, std::abs(state.alpha) * live);
  };
  FactorState best = {within_bounds(forces, point.s), point.alpha, 0.};
  if (anchor)
  {
    towards(best.x, share, anchor->x);
    best.alpha += share * (anchor->alpha - best.alpha);
  }
  best.residual = residual(best);
  FactorState trial = best;
  Patience patience;
  while (best.residual > rounding_of_bound && patience.lasts())
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
    trial.residual = residual(trial);
    patience.see(trial.residual, best.residual);
    if (trial.residual < best.residual)
      best = trial;
  }
  return best;
}

FactorMotion mechanism_near(BoundedForces &forces,
                            const SelfDual::Loads &loads,
                            const SelfDual::Point &point,
                            const std::optional<FactorMotion> &anchor,
                            const double share)
{
  const InvalidOperationsAllowed allowed;
  FactorMotion best = {point.u, point.z, 0.};
  if (anchor)
  {
    towards(best.u, share, anchor->u);
    towards(best.z, share, anchor->z);
  }
  best.closing = closing_of(forces, best.u);
  FactorMotion trial = best;
  Patience patience;
  while (best.closing > rounding_of_motion && patience.lasts())
  {
    std::vector<double> left = forces.along(trial.u);
    add(left, 1., forces.of_rows(trial.z));
    const double work =
        loads.live.empty() ? 0. : loads.sense - dot(loads.live, trial.u);
    // As with the forces.
    std::vector<double> weights = trial.z;
    if (!anchor)
      for (double &weight : weights)
        weight *= weight;
    const std::vector<double> k = forces.inverse_sums(weights);
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
      dz[b] *= weights[b];
      fastest = std::max(fastest, -dz[b] / trial.z[b]);
    }
    const double part =
        fastest > fraction_to_bound ? fraction_to_bound / fastest : 1.;
    add(trial.u, part, du);
    add(trial.z, part, dz);
    trial.closing = closing_of(forces, trial.u);
    patience.see(trial.closing, best.closing);
    if (trial.closing < best.closing)
      best = trial;
  }
  return best;
}
} // namespace Voussoir
