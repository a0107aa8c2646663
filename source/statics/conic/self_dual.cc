// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/conic/self_dual.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/** tau over kappa, and the error over the gain, at which a ray is one. */
constexpr double small_tau = 1e-2, error_of_ray = 1e-8;

/** Steps without less products that end the search. */
constexpr unsigned int n_patience_of_gap = 10;
constexpr double progress = 0.7;
constexpr double best_merit = 1e-15;
/** The first slack, over the root of the stiffness or the whole range. */
constexpr double first_slack = 100.;
/** A bound, over the loads, that hardly matters to begin with. */
constexpr double far_bound = 100.;
/** A factor, over that with which live loads are dead ones, that is zero. */
constexpr double small_factor = 1e-3;
} // namespace

SelfDual::SelfDual(BoundedForces &forces, Loads loads_in)
    : forces(forces), loads(std::move(loads_in)),
      size_of_loads(std::max(
          {largest_component(loads.dead), largest_component(loads.live)})),
      least_product(std::numeric_limits<double>::infinity())
{
  const BoundedRows &rows = forces.of();
  double strongest = 0.;
  for (const BoundedForces::Bound &bound : forces.bounds())
  {
    // All products start from one, and forces far inside their bounds, so that
    // joints need hardly open to begin with: the displacement, with the work
    // one, is small beside the forces. Bounds may be farther away still.
    const BoundedRows::Bounds &of_row = rows.bounds()[bound.row];
    const double k =
        first_slack *
        std::min(
            std::sqrt(rows.joints()[rows.joint_of_row(bound.row)].stiffness()),
            of_row.greatest - of_row.least);
    const double s = bound.limit > far_bound ? bound.limit : k;
    now.s.push_back(s);
    now.z.push_back(1. / s);
    strongest = std::max(strongest, bound.limit);
  }
  now.x.assign(rows.n_all_rows(), 0.);
  now.u.assign(forces.n_unknowns(), 0.);
  now.alpha = 0.;
  now.tau = now.kappa = 1.;
  const double live = largest_component(loads.live);
  if (live > 0.)
    unit_of_alpha = small_factor *
                    std::max(largest_component(loads.dead), strongest) / live;
  judge();
}

SelfDual::Point SelfDual::point() const
{
  Point point = {now.x, now.u, now.s, now.z, now.alpha};
  for (auto *const v : {&point.x, &point.u, &point.s, &point.z})
    for (double &component : *v)
      component /= now.tau;
  point.alpha /= now.tau;
  return point;
}

double SelfDual::mean_product() const
{
  return (dot(now.s, now.z) + now.tau * now.kappa) / (now.s.size() + 1.);
}

SelfDual::Residuals SelfDual::residuals() const
{
  Residuals r;
  r.balance = forces.on_bodies(now.x);
  add(r.balance, now.tau, loads.dead);
  if (!loads.live.empty())
    add(r.balance, now.alpha, loads.live);
  r.bounds = forces.at_bounds(now.x);
  double h_z = 0.;
  for (std::size_t b = 0; b < r.bounds.size(); ++b)
  {
    const double limit = forces.bounds()[b].limit;
    r.bounds[b] += now.s[b] - now.tau * limit;
    h_z += limit * now.z[b];
  }
  r.multipliers = forces.along(now.u);
  add(r.multipliers, 1., forces.of_rows(now.z));
  r.live_work =
      loads.live.empty() ? 0. : dot(loads.live, now.u) - now.tau * loads.sense;
  r.gap = now.kappa - loads.sense * now.alpha - (dot(loads.dead, now.u) - h_z);
  return r;
}

/** Find the residuals and what they say. */
SelfDual::State SelfDual::judge()
{
  residual = residuals();
  const double primal = -loads.sense * now.alpha;
  const double dual = primal - residual.gap + now.kappa;
  const auto relative = [&](const std::vector<double> &v) {
    return largest_component(v) / now.tau;
  };
  double of_multipliers = 0.;
  const BoundedRows &rows = forces.of();
  for (unsigned int e = 0; e < rows.joints().size(); ++e)
  {
    const double root = std::sqrt(rows.joints()[e].stiffness());
    for (std::size_t k = rows.first_row(e); k < rows.first_row(e + 1); ++k)
      of_multipliers =
          std::max(of_multipliers, std::abs(residual.multipliers[k]) * root);
  }
  double of_bounds = 0.;
  for (std::size_t b = 0; b < residual.bounds.size(); ++b)
    of_bounds = std::max(of_bounds, std::abs(residual.bounds[b]) /
                                        (1. + forces.bounds()[b].limit));
  const double reference = std::max(std::abs(primal) / now.tau,
                                    unit_of_alpha > 0. ? unit_of_alpha : 1.);
  error = std::max({std::abs(primal - dual) / now.tau / reference,
                    relative(residual.balance) / size_of_loads,
                    of_bounds / now.tau, of_multipliers / now.tau,
                    std::abs(residual.live_work) / now.tau});
  if (error < best_merit)
    return State::optimal;

  if (now.tau < small_tau * now.kappa)
  {
    std::vector<double> balance = residual.balance;
    add(balance, -now.tau, loads.dead);
    double of_ray = 0.;
    for (std::size_t b = 0; b < residual.bounds.size(); ++b)
      of_ray = std::max(of_ray, std::abs(residual.bounds[b] +
                                         now.tau * forces.bounds()[b].limit));
    const double live_work =
        loads.live.empty() ? 0. : residual.live_work + now.tau * loads.sense;
    if (dual > 0. &&
        std::max(largest_component(residual.multipliers), std::abs(live_work)) <
            error_of_ray * dual / size_of_loads)
      return State::infeasible;
    if (primal < 0. &&
        largest_component(balance) < -error_of_ray * primal * size_of_loads &&
        of_ray < -error_of_ray * primal)
      return State::unbounded;
  }
  const double mean = mean_product();
  if (mean < progress * least_product)
  {
    least_product = mean;
    iteration_of_least = iterations;
  }
  return iterations > iteration_of_least + n_patience_of_gap ? State::stalled
                                                             : State::running;
}
} // namespace Voussoir
