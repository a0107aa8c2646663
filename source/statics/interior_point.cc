// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/floating_point.h>
#include <voussoir/statics/interior_point.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
using Joint = Structure::Joint;
using Jump = Structure::Jump;

namespace
{
/** The part of the way to the end of its domain that a step may take. */
constexpr double fraction_to_boundary = 0.99;
/** The least factor by which a step aims to multiply the products. */
constexpr double least_centring = 1e-6;

/**
 * The compliance, relative to d_e/|e|, with which a step sees joints that have
 * none: it bounds the coefficients of the linear system and with it the digits
 * that are lost, and slows the last steps down by no more than this factor.
 */
constexpr double compliance_of_rigid_joints = 1e-6;

/** The stopping criteria of the conjugate gradients; see solve(). */
constexpr double reduction_of_residual = 1e-13;
constexpr unsigned int n_gradients = 10;
/** The largest shift that these make up for. */
constexpr double largest_shift = 1e-6;

/** The part of a step below which rounding dominates. */
constexpr double shortest_step = 1e-6;

double largest_component(const std::vector<double> &v)
{
  double largest = 0.;
  for (const double component : v)
    largest = std::max(largest, std::abs(component));
  return largest;
}

double dot(const std::vector<double> &a, const std::vector<double> &b)
{
  long double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return static_cast<double>(sum);
}
} // namespace

InteriorPoint::InteriorPoint(const DiscreteProblem &problem,
                             const std::vector<JointCost> &costs,
                             const Aim aim)
    : problem(problem), aim(aim), system(problem, LinearSolver::automatic),
      displacement(problem.n_dofs(), 0.),
      alpha(aim == Aim::load_factor ? 0. : 1.),
      stiffness(problem.joints().size())
{
  for (unsigned int e = 0; e < costs.size(); ++e)
  {
    // All products start from one times the weight, with a pressure of one.
    const Joint &joint = problem.joints()[e];
    const double weight = joint.length * joint.distance;
    states.push_back(
        {costs[e],
         aim == Aim::load_factor
             ? compliance_of_rigid_joints / joint.stiffness()
             : 0.,
         weight, joint.length, joint.distance,
         FrictionCone(joint.strength, costs[e].smoothing, weight)});
  }
}

bool InteriorPoint::step()
{
  // If rounding leaves no step, the result is not a number; it is checked
  // before it is used.
  const InvalidOperationsAllowed allowed;
  ++iterations;
  const double mean = product();
  find_shortages();
  if (!prepare())
    return false;
  const Step predictor = direction(0.);
  const Parts parts = longest(predictor, 1.);
  const double rest = 1. - std::min(parts.of_forces, parts.of_displacements);
  const double centring = std::max(rest * rest * rest, least_centring);
  const Step corrector = direction(centring * mean);
  const Parts possible = longest(corrector, fraction_to_boundary);
  if (!(std::max(possible.of_forces, possible.of_displacements) >
        shortest_step))
    return false;
  return take(corrector, possible);
}

/** The forces that are missing to the balance of each body. */
std::vector<double> InteriorPoint::missing_forces() const
{
  std::vector<double> missing(problem.n_dofs(), 0.);
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
    for (unsigned int i = 0; i < 2; ++i)
      missing[problem.dof(b, i)] = alpha * problem.loads()[b][i];
  for (unsigned int e = 0; e < states.size(); ++e)
    problem.add_jump_gradient(problem.joints()[e],
                              {states[e].p, -states[e].friction.force()},
                              missing.data());
  return missing;
}

void InteriorPoint::find_shortages()
{
  for (unsigned int e = 0; e < states.size(); ++e)
  {
    State &state = states[e];
    const Jump jump = problem.jump(problem.joints()[e], displacement.data());
    state.short_z =
        jump.normal + state.cost.normal_compliance * state.p - state.z;
    state.short_v = jump.tangential -
                    state.cost.tangential_compliance * state.friction.force() -
                    state.friction.sliding();
  }
}

/** Linearise, and prepare the linear system. */
bool InteriorPoint::prepare()
{
  for (unsigned int e = 0; e < states.size(); ++e)
  {
    State &state = states[e];
    stiffness[e].normal =
        state.p /
        (state.z +
         (state.cost.normal_compliance + state.extra_compliance) * state.p);
    stiffness[e].tangential = 0.;
    if (!state.friction.exists())
      continue;
    state.friction.linearise();
    stiffness[e].tangential =
        1. / (state.friction.compliance() + state.cost.tangential_compliance +
              state.extra_compliance);
  }
  const bool finite =
      std::all_of(stiffness.begin(), stiffness.end(), [](const Jump &k) {
        return std::isfinite(k.normal) && std::isfinite(k.tangential);
      });
  if (!finite)
    return false;
  double shift = least_shift;
  while (!system.prepare(stiffness, shift))
    if ((shift *= factor_of_shift) > largest_shift)
      return false;
  if (aim == Aim::load_factor)
  {
    std::vector<double> loads(problem.n_dofs(), 0.);
    for (unsigned int b = 0; b < problem.n_bodies(); ++b)
      for (unsigned int i = 0; i < 2; ++i)
        loads[problem.dof(b, i)] = problem.loads()[b][i];
    u_of_load = solve(loads);
  }
  return true;
}

/**
 * Solve the linear system without its shift, by conjugate gradients that the
 * factorisation of the one with it preconditions: where joints slide far, the
 * mechanism meets next to no stiffness but the shift.
 */
std::vector<double> InteriorPoint::solve(const std::vector<double> &right)
{
  std::vector<double> u(right.size(), 0.), best(u), left(right), d(u);
  double previous = 1., least = largest_component(right);
  const double enough = reduction_of_residual * least;
  for (unsigned int k = 0; k < n_gradients && least > enough; ++k)
  {
    std::vector<double> z = system.solve(left);
    problem.remove_translations(z);
    const double now = dot(left, z);
    for (unsigned int i = 0; i < d.size(); ++i)
      d[i] = z[i] + now / previous * d[i];
    previous = now;

    std::vector<double> force(right.size(), 0.);
    long double energy = 0.;
    for (unsigned int e = 0; e < states.size(); ++e)
    {
      const Joint &joint = problem.joints()[e];
      const Jump jump = problem.jump(joint, d.data());
      const Jump f = {stiffness[e].normal * jump.normal,
                      stiffness[e].tangential * jump.tangential};
      problem.add_jump_gradient(joint, f, force.data());
      energy += f.normal * jump.normal + f.tangential * jump.tangential;
    }
    const double length = now / energy;
    if (!(now > 0.) || !std::isfinite(length))
      break;
    for (unsigned int i = 0; i < u.size(); ++i)
    {
      u[i] += length * d[i];
      left[i] -= length * force[i];
    }
    const double size = largest_component(left);
    if (size < least)
    {
      best = u;
      least = size;
    }
  }
  return best;
}

/** Newton's step to where all products are @p target times their weights. */
InteriorPoint::Step InteriorPoint::direction(const double target)
{
  // The changes of p and q are those below less stiffness times [du].
  std::vector<Jump> constant(states.size());
  std::vector<double> right = missing_forces();
  for (unsigned int e = 0; e < states.size(); ++e)
  {
    const State &state = states[e];
    const double aim_at = target * state.weight;
    constant[e] = {
        stiffness[e].normal * (aim_at / state.p - state.z - state.short_z), 0.};
    if (state.friction.exists())
      constant[e].tangential =
          stiffness[e].tangential *
          (state.short_v - state.friction.constant(aim_at));
    problem.add_jump_gradient(problem.joints()[e],
                              {constant[e].normal, -constant[e].tangential},
                              right.data());
  }

  Step step = {solve(right), {}, 0.};
  if (aim == Aim::load_factor)
  {
    // The loads, at a factor of one, do the work one.
    step.load_factor =
        (1. - problem.work(displacement.data()) - problem.work(step.u.data())) /
        problem.work(u_of_load.data());
    for (unsigned int i = 0; i < step.u.size(); ++i)
      step.u[i] += step.load_factor * u_of_load[i];
  }

  step.joints.reserve(states.size());
  for (unsigned int e = 0; e < states.size(); ++e)
  {
    const State &state = states[e];
    const Jump jump = problem.jump(problem.joints()[e], step.u.data());
    const double dp = constant[e].normal - stiffness[e].normal * jump.normal;
    const double dz =
        jump.normal + state.short_z +
        (state.cost.normal_compliance + state.extra_compliance) * dp;
    FrictionCone::Step friction = {0., 0., 0., 0.};
    if (state.friction.exists())
      friction = state.friction.step(
          target * state.weight,
          constant[e].tangential + stiffness[e].tangential * jump.tangential);
    step.joints.push_back({dp, dz, friction});
  }
  return step;
}

/** The part of a step that may be taken, at most one. */
InteriorPoint::Parts InteriorPoint::longest(const Step &step,
                                            const double fraction) const
{
  const auto to_zero = [](const double x, const double dx) {
    return dx < 0. ? -x / dx : std::numeric_limits<double>::infinity();
  };
  Parts parts = {1. / fraction, 1. / fraction};
  for (unsigned int e = 0; e < states.size(); ++e)
  {
    const State &state = states[e];
    const StateStep &d = step.joints[e];
    parts.of_forces = std::min(parts.of_forces, to_zero(state.p, d.p));
    parts.of_displacements =
        std::min(parts.of_displacements, to_zero(state.z, d.z));
    if (!state.friction.exists())
      continue;
    parts.of_forces =
        std::min(parts.of_forces, state.friction.longest_of_force(d.friction));
    parts.of_displacements = std::min(
        parts.of_displacements, state.friction.longest_of_sliding(d.friction));
  }
  parts.of_forces = fraction * parts.of_forces;
  parts.of_displacements = fraction * parts.of_displacements;
  // A compliance ties displacements to forces.
  if (aim == Aim::least_cost)
    parts.of_forces = parts.of_displacements =
        std::min(parts.of_forces, parts.of_displacements);
  return parts;
}

/** Take parts of a step, unless rounding has made it no number. */
bool InteriorPoint::take(const Step &step, const Parts &parts)
{
  const std::vector<State> before = states;
  for (unsigned int e = 0; e < states.size(); ++e)
  {
    states[e].p += parts.of_forces * step.joints[e].p;
    states[e].z += parts.of_displacements * step.joints[e].z;
    states[e].friction.take(step.joints[e].friction, parts.of_forces,
                            parts.of_displacements);
  }
  if (!std::isfinite(product()) || !std::isfinite(step.load_factor))
  {
    states = before;
    return false;
  }
  for (unsigned int i = 0; i < displacement.size(); ++i)
    displacement[i] += parts.of_displacements * step.u[i];
  alpha += parts.of_forces * step.load_factor;
  return true;
}

const std::vector<double> &InteriorPoint::u() const
{
  return displacement;
}

InterfaceForces InteriorPoint::forces() const
{
  InterfaceForces forces;
  for (const State &state : states)
  {
    forces.normal.push_back(-state.p);
    forces.tangential.push_back(state.friction.force());
  }
  return forces;
}

double InteriorPoint::load_factor() const
{
  return alpha;
}

double InteriorPoint::imbalance() const
{
  return largest_component(missing_forces());
}

double InteriorPoint::product() const
{
  double sum = 0.;
  unsigned int n = states.size();
  for (const State &state : states)
  {
    sum += state.p * state.z / state.weight;
    if (!state.friction.exists())
      continue;
    sum += state.friction.product() / state.weight;
    ++n;
  }
  return sum / n;
}

unsigned int InteriorPoint::n_iterations() const
{
  return iterations;
}

double InteriorPoint::seconds_of_systems() const
{
  return system.seconds();
}
} // namespace Voussoir
