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
constexpr unsigned int n_patience_of_gap = 10, n_patience_of_curved = 40;
constexpr double progress = 0.7;
constexpr double best_merit = 1e-15;
/** A bound, over the loads, that hardly matters to begin with. */
constexpr double far_bound = 100.;
/** A factor, over that with which live loads are dead ones, that is zero. */
constexpr double small_factor = 1e-3;

/** The largest load, or the unit of forces if there is none. */
double size_of(const SelfDual::Program &program)
{
  const double size = std::max(largest_component(program.dead),
                               largest_component(program.live));
  return size > 0. ? size : 1.;
}
} // namespace

SelfDual::SelfDual(ConicForces &forces,
                   Program program_in,
                   const Variables *start)
    : forces(forces), program(std::move(program_in)), limits(forces.limits()),
      n_bounds(forces.bounds().size()), size_of_loads(size_of(program)),
      least_mean(std::numeric_limits<double>::infinity())
{
  if (start != nullptr)
    now = *start;
  else if (forces.of().is_plane())
    take_usual_start();
  else
    take_start_of_slacks();
  if (const double live = largest_component(program.live); live > 0.)
  {
    double strongest = 0.;
    for (const ConicForces::Bound &bound : forces.bounds())
      strongest = std::max(strongest, bound.limit);
    for (const ForceRows::Section &section : forces.of().sections())
      strongest = std::max(strongest, section.strength);
    for (const ForceRows::Disc &disc : forces.of().discs())
      strongest = std::max(strongest, disc.strength);
    unit = small_factor * std::max(largest_component(program.dead), strongest) /
           live;
    if (!(unit > 0.))
      unit = 1.;
  }
  else if (program.has_curvature)
    unit = 0.;
  else if (!program.cost.empty())
    unit = size_of_loads;
  judge();
}

void SelfDual::go_on(Progress from)
{
  now = std::move(from.at);
  iterations = from.iterations;
  iteration_of_least = from.iteration_of_least;
  least_mean = from.least_mean;
  judge();
}

/**
 * All products start from one. The displacement, with the work one, is small
 * beside the forces.
 */
void SelfDual::take_usual_start()
{
  const ForceRows &rows = forces.of();
  const auto slack = [&](const std::size_t row, const double range) {
    const double root =
        std::sqrt(rows.joints()[rows.joint_of_row(row)].stiffness());
    return program.has_curvature ? root
                                 : program.first_slack * std::min(root, range);
  };
  for (const ConicForces::Bound &bound : forces.bounds())
  {
    // Bounds may be farther away still.
    const ForceRows::Bounds &of_row = rows.bounds()[bound.row];
    const double k = slack(bound.row, of_row.greatest - of_row.least);
    const double s = bound.limit > far_bound ? bound.limit : k;
    now.s.push_back(s);
    now.z.push_back(1. / s);
  }
  now.s.resize(forces.n_slacks());
  now.z.resize(forces.n_slacks());
  for (std::size_t k = 0; k < forces.cones().size(); ++k)
  {
    const ConicForces::Cone &cone = forces.cones()[k];
    QuadraticCone::Vector s = cone.limit;
    if (QuadraticCone::contains(s))
      s[0] = std::max(s[0], slack(cone.row, s[0]));
    else if (cone.n_rows == 3)
      s[0] = cone.b[0][0] *
             slack(cone.row, std::numeric_limits<double>::infinity());
    else
    {
      // As with such a pressure at this end.
      const double pressure = slack(cone.row, s[0]);
      s[0] += pressure;
      s[1] += pressure;
    }
    forces.set_cone(now.s, k, s);
    const double det = QuadraticCone::det(s);
    forces.set_cone(now.z, k, {{s[0] / det, -s[1] / det, -s[2] / det}});
  }
  now.x.assign(rows.n_all_rows(), 0.);
  now.u.assign(rows.n_dofs(), 0.);
  now.alpha = 0.;
  now.tau = now.kappa = 1.;
}

/**
 * The same in space, with forces that have these slacks: what slacks lack there
 * is none, and stays so. Beside the matrices of cones it would have no digits.
 */
void SelfDual::take_start_of_slacks()
{
  const ForceRows &rows = forces.of();
  now.alpha = 0.;
  now.tau = now.kappa = 1.;
  now.u.assign(rows.n_dofs(), 0.);
  now.x.assign(rows.n_all_rows(), 0.);
  for (const ConicForces::Bound &bound : forces.bounds())
  {
    const Joint &joint = rows.joints()[rows.joint_of_row(bound.row)];
    const double root = std::sqrt(joint.stiffness());
    double &x = now.x[bound.row];
    if (bound.limit == 0.)
      x = -(program.has_curvature ? root : program.first_slack * root);
    else if (bound.sign < 0.)
      x = x == 0. ? -0.5 * bound.limit : std::max(x, -0.5 * bound.limit);
  }
  for (const ForceRows::FrictionCone &cone : rows.friction_cones())
  {
    const double root =
        std::sqrt(rows.joints()[rows.joint_of_row(cone.row)].stiffness());
    now.x[cone.row] =
        -std::min(program.has_curvature ? root : program.first_slack * root,
                  0.5 * cone.strength);
  }
  now.s = slacks_of_forces();
  now.z.resize(now.s.size());
  for (std::size_t b = 0; b < n_bounds; ++b)
    now.z[b] = 1. / now.s[b];
  for (std::size_t k = 0; k < forces.cones().size(); ++k)
  {
    const QuadraticCone::Vector s = forces.of_cone(now.s, k);
    forces.set_cone(now.z, k, {{1. / s[0], 0., 0.}});
  }
}

/** tau h - B x. */
std::vector<double> SelfDual::slacks_of_forces() const
{
  std::vector<double> s = forces.at_slacks(now.x);
  for (std::size_t b = 0; b < s.size(); ++b)
    s[b] = now.tau * limits[b] - s[b];
  return s;
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
  return (dot(now.s, now.z) + now.tau * now.kappa) /
         (n_bounds + forces.cones().size() + 1.);
}

/** x^T Q y. */
double SelfDual::curvature_of(const std::vector<double> &x,
                              const std::vector<double> &y) const
{
  double sum = 0.;
  if (program.has_curvature)
    for (std::size_t k = 0; k < x.size(); ++k)
      sum += forces.curvature()[k] * x[k] * y[k];
  return sum;
}

SelfDual::Residuals SelfDual::residuals() const
{
  Residuals r;
  r.balance = forces.on_bodies(now.x);
  add(r.balance, now.tau, program.dead);
  if (!program.live.empty())
    add(r.balance, now.alpha, program.live);
  r.bounds = forces.at_slacks(now.x);
  for (std::size_t b = 0; b < r.bounds.size(); ++b)
    r.bounds[b] += now.s[b] - now.tau * limits[b];
  r.multipliers = forces.along(now.u);
  add(r.multipliers, 1., forces.of_rows(now.z));
  if (program.has_curvature)
    for (std::size_t k = 0; k < now.x.size(); ++k)
      r.multipliers[k] += forces.curvature()[k] * now.x[k];
  if (!program.cost.empty())
    add(r.multipliers, now.tau, program.cost);
  r.live_work = program.live.empty()
                    ? 0.
                    : dot(program.live, now.u) - now.tau * program.sense;
  r.gap = now.kappa - program.sense * now.alpha - gain();
  if (program.has_curvature)
    r.gap += curvature_of(now.x, now.x) / now.tau;
  if (!program.cost.empty())
    r.gap += dot(program.cost, now.x);
  return r;
}

double SelfDual::gain() const
{
  return dot(program.dead, now.u) - dot(limits, now.z);
}

double SelfDual::objective() const
{
  double sum = -program.sense * now.alpha / now.tau;
  if (program.has_curvature)
    sum += 0.5 * curvature_of(now.x, now.x) / (now.tau * now.tau);
  if (!program.cost.empty())
    sum += dot(program.cost, now.x) / now.tau;
  return sum;
}

double SelfDual::find_error(const double primal, const double dual) const
{
  const auto relative = [&](const std::vector<double> &v) {
    return largest_component(v) / now.tau;
  };
  double of_multipliers = 0.;
  const ForceRows &rows = forces.of();
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
                                        (1. + std::abs(limits[b])));
  const double reference = std::max(std::abs(primal) / now.tau, unit);
  return std::max({std::abs(primal - dual) / now.tau /
                       std::max(reference, std::numeric_limits<double>::min()),
                   relative(residual.balance) / size_of_loads,
                   of_bounds / now.tau, of_multipliers / now.tau,
                   std::abs(residual.live_work) / now.tau});
}

/** Whether the point is a ray that proves that there is no optimum. */
SelfDual::State SelfDual::judge_ray(const double primal,
                                    const double gain) const
{
  std::vector<double> balance = residual.balance;
  add(balance, -now.tau, program.dead);
  std::vector<double> multipliers = residual.multipliers;
  if (program.has_curvature)
    for (std::size_t k = 0; k < now.x.size(); ++k)
      multipliers[k] -= forces.curvature()[k] * now.x[k];
  if (!program.cost.empty())
    add(multipliers, -now.tau, program.cost);
  double of_ray = 0.;
  for (std::size_t b = 0; b < residual.bounds.size(); ++b)
    of_ray =
        std::max(of_ray, std::abs(residual.bounds[b] + now.tau * limits[b]));
  const double live_work =
      program.live.empty() ? 0. : residual.live_work + now.tau * program.sense;
  if (gain > 0. &&
      std::max(largest_component(multipliers), std::abs(live_work)) <
          error_of_ray * gain / size_of_loads)
    return State::infeasible;
  if (primal < 0. && !program.has_curvature &&
      largest_component(balance) < -error_of_ray * primal * size_of_loads &&
      of_ray < -error_of_ray * primal)
    return State::unbounded;
  return State::running;
}

/** Find the residuals and what they say. */
SelfDual::State SelfDual::judge()
{
  residual = residuals();
  const double primal = objective() * now.tau;
  const double dual = primal - residual.gap + now.kappa;
  error = find_error(primal, dual);
  if (error < best_merit)
    return State::optimal;
  if (now.tau < small_tau * now.kappa)
    if (const State ray =
            judge_ray(primal, program.has_curvature ? gain() : dual);
        ray != State::running)
      return ray;
  const double mean = mean_product();
  if (!std::isfinite(error + mean))
    return State::stalled;
  if (mean < progress * least_mean)
  {
    least_mean = mean;
    iteration_of_least = iterations;
  }
  const unsigned int n_patience =
      program.has_curvature ? n_patience_of_curved : n_patience_of_gap;
  return iterations > iteration_of_least + n_patience ? State::stalled
                                                      : State::running;
}
} // namespace Voussoir
