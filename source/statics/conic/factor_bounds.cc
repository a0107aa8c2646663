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
/** The room of a section, over its strength, to be inside. */
constexpr double least_room = 1e-14;
/** Errors, relative to the loads and to the displacement, that are rounding. */
constexpr double rounding_of_bound = 1e-14, rounding_of_motion = 1e-14;
/** The residual from which on what a round does not halve is rounding. */
constexpr double small_residual_of_state = 1e-12;
/** The stopping criteria of the conjugate gradients: over the right-hand side,
 * and over the loads. */
constexpr double reduction_of_imbalance = 1e-15, small_imbalance = 1e-16;
constexpr unsigned int n_bound_gradients = 15;

/** Solve with the matrix that is prepared, and the live loads for a border. */
ConicForces::Bordered solve(ConicForces &forces,
                            const std::vector<double> &live,
                            const std::vector<double> &right,
                            const double work,
                            const double enough = 0.)
{
  if (!live.empty())
    forces.set_border(live);
  return forces.solve(
      right, work,
      std::max(reduction_of_imbalance * largest_component(right), enough),
      n_bound_gradients);
}

std::vector<double> missing(const ConicForces &forces,
                            const SelfDual::Program &program,
                            const FactorState &state)
{
  std::vector<double> left = forces.on_bodies(state.x);
  add(left, 1., program.dead);
  if (!program.live.empty())
    add(left, state.alpha, program.live);
  for (double &component : left)
    component = -component;
  return left;
}

/** Counts the rounds of a correction. */
class Patience
{
public:
  /** @param small an error from which on what is not halved is rounding. */
  explicit Patience(const double small = 0.) : small(small) {}
  bool lasts() const
  {
    return n < n_bound_rounds && n_in_vain < n_rounds_without_gain;
  }
  void see(const double error, const double least)
  {
    ++n;
    n_in_vain = error < least ? 0 : n_in_vain + 1;
    if (least <= small && !(error < 0.5 * least))
      n = n_bound_rounds;
  }

private:
  const double small;
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

/**
 * The largest closing where a force has no limit, and what moves where it has
 * none in either direction, over the displacement: with a cost what closes
 * faster than that gains.
 */
double closing_of(const ConicForces &forces,
                  const SelfDual::Program &program,
                  const std::vector<double> &u)
{
  std::vector<double> jumps = forces.along(u);
  if (!program.cost.empty())
    add(jumps, 1., program.cost);
  const auto &bounds = forces.bounds();
  double closing = 0.;
  for (std::size_t b = 0; b < bounds.size(); ++b)
    if (b + 1 < bounds.size() && bounds[b + 1].row == bounds[b].row)
      ++b;
    else if (forces.of().bounds()[bounds[b].row].greatest == 0.)
      closing = std::max(closing, bounds[b].sign * jumps[bounds[b].row]);
  for (const unsigned int row : forces.without_limits())
    closing = std::max(closing, std::abs(jumps[row]));
  for (const ForceRows::FrictionCone &cone : forces.of().friction_cones())
    if (!std::isfinite(cone.strength))
      closing = std::max(closing,
                         jumps[cone.row] + cone.coefficient *
                                               std::hypot(jumps[cone.row + 1],
                                                          jumps[cone.row + 2]));
  return closing /
         std::max(largest_component(u), largest_component(program.cost));
}

/** The work of the live loads, over that of its terms, where it is to be none.
 */
double error_of_work(const SelfDual::Program &program,
                     const std::vector<double> &u)
{
  if (program.live.empty() || program.sense != 0.)
    return 0.;
  double of_terms = 0.;
  for (std::size_t k = 0; k < u.size(); ++k)
    of_terms += std::abs(program.live[k] * u[k]);
  return of_terms > 0. ? std::abs(dot(program.live, u)) / of_terms : 0.;
}

/** The slacks of forces. */
std::vector<double> slacks_of(const ConicForces &forces,
                              const std::vector<double> &x)
{
  std::vector<double> slack = forces.limits();
  add(slack, -1., forces.at_slacks(x));
  return slack;
}

/** Move the forces of a section inside, if they are not. */
void move_inside(const ForceRows::Section &section, std::vector<double> &x)
{
  double *const force = &x[section.row];
  const double middle = -0.25 * section.strength;
  const auto is_inside = [&]() {
    const double square = (force[0] + force[1]) * (force[0] + force[1]);
    return std::min(-force[0], -force[1]) * 2. * section.strength >
           square + least_room * section.strength * section.strength;
  };
  for (double share = least_room; !is_inside() && share <= 1.; share *= 10.)
    for (unsigned int k = 0; k < 2; ++k)
      force[k] += share * (middle - force[k]);
}

/** Move the tangential forces of a disc inside, if they are not. */
void move_inside(const ForceRows::Disc &disc, std::vector<double> &x)
{
  double *const force = &x[disc.row];
  const double size = std::hypot(force[0], force[1]);
  const double largest = (1. - least_room) * disc.strength;
  if (size > largest)
    for (unsigned int k = 0; k < 2; ++k)
      force[k] *= largest / size;
}

/** The forces of a cone of friction, by its slacks. */
void set_from_slacks(const ForceRows::FrictionCone &cone,
                     const QuadraticCone::Vector &slack,
                     std::vector<double> &x)
{
  double *const force = &x[cone.row];
  force[0] = -slack[0] / cone.coefficient;
  force[1] = slack[1];
  force[2] = slack[2];
  const double largest = (1. - least_room) * cone.strength;
  if (-force[0] > largest)
  {
    const double share = largest / -force[0];
    for (unsigned int k = 0; k < 3; ++k)
      force[k] *= share;
  }
}

/** Forces strictly within their bounds, in proportion to the slacks. */
std::vector<double> within_bounds(const ConicForces &forces,
                                  const SelfDual::Point &point)
{
  std::vector<double> x = point.x;
  const std::vector<double> &slack = point.s;
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
      x[bounds[b].row] = bounds[b].sign * (bounds[b].limit - slack[b]);
  for (const ForceRows::Section &section : forces.of().sections())
    move_inside(section, x);
  for (const ForceRows::Disc &disc : forces.of().discs())
    move_inside(disc, x);
  std::size_t k = 0;
  for (const ForceRows::FrictionCone &cone : forces.of().friction_cones())
  {
    while (forces.cones()[k].row != cone.row)
      ++k;
    set_from_slacks(cone, forces.of_cone(point.s, k), x);
  }
  return x;
}

/**
 * What keeps forces with these slacks within their bounds: of a row with two
 * the nearer. Squares do in the first step; with an anchor there is room, and
 * less is lost to rounding.
 */
ConicForces::Weights weights_of_state(const ConicForces &forces,
                                      const std::vector<double> &slack,
                                      const bool are_square)
{
  ConicForces::Weights weights;
  const auto &bounds = forces.bounds();
  for (std::size_t b = 0; b < bounds.size(); ++b)
  {
    double d = slack[b];
    const bool is_first =
        b + 1 < bounds.size() && bounds[b + 1].row == bounds[b].row;
    const bool is_second = b > 0 && bounds[b - 1].row == bounds[b].row;
    if (is_first || is_second)
      d = std::min(d, slack[is_first ? b + 1 : b - 1]);
    d = std::max(d, 0.);
    // One bound of a row counts.
    weights.of_bounds.push_back(is_second ? 0. : 1. / (are_square ? d * d : d));
  }
  for (std::size_t k = 0; k < forces.cones().size(); ++k)
  {
    weights.of_cones.push_back(
        QuadraticCone::Scaling::of_barrier(forces.of_cone(slack, k)));
    if (!are_square)
    {
      double &square = weights.of_cones.back().eta_squared;
      square = std::sqrt(square);
    }
  }
  return weights;
}

/** The inverse of the part of a step to where a slack vanishes. */
double inverse_of_longest(const ConicForces &forces,
                          const std::vector<double> &v,
                          const std::vector<double> &step)
{
  double fastest = 0.;
  for (std::size_t b = 0; b < forces.bounds().size(); ++b)
    if (v[b] > 0.)
      fastest = std::max(fastest, -step[b] / v[b]);
  for (std::size_t k = 0; k < forces.cones().size(); ++k)
    fastest =
        std::max(fastest, QuadraticCone::inverse_of_longest(
                              forces.of_cone(v, k), forces.of_cone(step, k)));
  return fastest;
}
} // namespace

FactorState state_near(ConicForces &forces,
                       const SelfDual::Program &program,
                       const SelfDual::Point &point,
                       const std::optional<FactorState> &anchor,
                       const double share)
{
  const InvalidOperationsAllowed allowed;
  const double dead = largest_component(program.dead),
               live = largest_component(program.live);
  const auto loads_of = [&](const FactorState &state) {
    const double loads = std::max(dead, std::abs(state.alpha) * live);
    return loads > 0. ? loads : 1.;
  };
  const auto residual = [&](const FactorState &state) {
    return largest_component(missing(forces, program, state)) / loads_of(state);
  };
  FactorState best = {within_bounds(forces, point), point.alpha, 0.};
  if (anchor)
  {
    towards(best.x, share, anchor->x);
    best.alpha += share * (anchor->alpha - best.alpha);
  }
  best.residual = residual(best);
  FactorState trial = best;
  Patience patience(small_residual_of_state);
  while (best.residual > rounding_of_bound && patience.lasts())
  {
    const std::vector<double> slack = slacks_of(forces, trial.x);
    if (!forces.prepare(weights_of_state(forces, slack, !anchor)))
      break;
    const ConicForces::Bordered change =
        solve(forces, program.live, missing(forces, program, trial), 0.,
              small_imbalance * loads_of(trial));
    std::vector<double> dx = forces.along(change.u);
    forces.multiply(dx);
    std::vector<double> of_slacks = forces.at_slacks(dx);
    for (double &component : of_slacks)
      component = -component;
    const double fastest = inverse_of_longest(forces, slack, of_slacks);
    const double part =
        fastest > fraction_to_bound ? fraction_to_bound / fastest : 1.;
    add(trial.x, part, dx);
    trial.alpha -= part * change.alpha;
    trial.residual = residual(trial);
    patience.see(trial.residual, best.residual);
    if (trial.residual < best.residual)
      best = trial;
  }
  return best;
}

FactorMotion mechanism_near(ConicForces &forces,
                            const SelfDual::Program &program,
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
  const auto error = [&](const FactorMotion &motion) {
    return std::max(motion.closing, error_of_work(program, motion.u));
  };
  best.closing = closing_of(forces, program, best.u);
  FactorMotion trial = best;
  Patience patience;
  // Forces without a limit stand for strengths so large that each digit counts.
  const double enough =
      forces.without_limits().empty() ? rounding_of_motion : 0.;
  const std::size_t n_bounds = forces.bounds().size();
  while (error(best) > enough && patience.lasts())
  {
    std::vector<double> left = forces.along(trial.u);
    add(left, 1., forces.of_rows(trial.z));
    if (!program.cost.empty())
      add(left, 1., program.cost);
    const double work =
        program.live.empty() ? 0. : program.sense - dot(program.live, trial.u);
    // As with the forces: W^2 of the multipliers stands for W^-2 of slacks.
    ConicForces::Weights weights;
    for (std::size_t b = 0; b < n_bounds; ++b)
      weights.of_bounds.push_back(anchor ? trial.z[b]
                                         : trial.z[b] * trial.z[b]);
    for (std::size_t k = 0; k < forces.cones().size(); ++k)
    {
      weights.of_cones.push_back(
          QuadraticCone::Scaling::of_dual_barrier(forces.of_cone(trial.z, k)));
      if (anchor)
      {
        double &square = weights.of_cones.back().eta_squared;
        square = std::sqrt(square);
      }
    }
    if (!forces.prepare(weights))
      break;
    forces.multiply(left);
    for (double &component : left)
      component = -component;
    const std::vector<double> du =
        solve(forces, program.live, forces.on_bodies(left), work).u;
    std::vector<double> change = forces.along(du);
    forces.multiply(change);
    for (std::size_t r = 0; r < left.size(); ++r)
      change[r] = left[r] - change[r];
    std::vector<double> dz = forces.at_slacks(change);
    for (std::size_t b = 0; b < n_bounds; ++b)
      dz[b] *= weights.of_bounds[b];
    for (std::size_t k = 0; k < forces.cones().size(); ++k)
      forces.set_cone(dz, k,
                      weights.of_cones[k].over_square(forces.of_cone(dz, k)));
    const double fastest = inverse_of_longest(forces, trial.z, dz);
    const double part =
        fastest > fraction_to_bound ? fraction_to_bound / fastest : 1.;
    add(trial.u, part, du);
    add(trial.z, part, dz);
    trial.closing = closing_of(forces, program, trial.u);
    patience.see(error(trial), error(best));
    if (error(trial) < error(best))
      best = trial;
  }
  return best;
}
} // namespace Voussoir
