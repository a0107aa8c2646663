// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/joint_law.h>
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/statics/conic/interior_point.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
using Joint = Structure::Joint;

namespace
{
/**
 * The products at the start, over their weights, of `near_least_cost`: near the
 * limit of the load displacements are far from the start, and with one it takes
 * half as many steps again (measured).
 */
constexpr double first_product_of_approach = 10.;
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
constexpr double reduction_of_step = 1e-13;
constexpr unsigned int n_step_gradients = 10;
/** The largest shift that these make up for. */
constexpr double largest_step_shift = 1e-6;

/** The part of a step below which rounding dominates. */
constexpr double shortest_usable_step = 1e-6;
} // namespace

InteriorPoint::InteriorPoint(const DiscreteProblem &problem,
                             const std::vector<JointCost> &costs,
                             const Aim aim)
    : problem(problem), aim(aim), system(problem, LinearSolver::automatic),
      displacement(problem.n_dofs(), 0.),
      alpha(aim == Aim::load_factor ? 0. : 1.)
{
  stiffness.of_rows.resize(problem.n_all_rows());
  const double first_product =
      aim == Aim::near_least_cost ? first_product_of_approach : 1.;
  for (unsigned int e = 0; e < costs.size(); ++e)
  {
    // All products start from the same times their weights, with a pressure of
    // one.
    const Joint &joint = problem.joints()[e];
    const double weight = joint.length * joint.distance;
    states.push_back({costs[e],
                      aim == Aim::load_factor
                          ? compliance_of_rigid_joints / joint.stiffness()
                          : 0.,
                      weight,
                      FrictionCone(problem.limit(e), costs[e].smoothing,
                                   first_product * weight)});
    const unsigned int n_contacts = problem.n_contacts(e);
    for (unsigned int r = 0; r < n_contacts; ++r)
      contacts.push_back({weight / n_contacts, joint.length / n_contacts,
                          first_product * joint.distance});
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
  for (Contact &contact : contacts)
    contact.second_order = 0.;
  const Step predictor = direction(0.);
  const Parts parts = longest(predictor, 1.);
  const double rest = 1. - std::min(parts.of_forces, parts.of_displacements);
  const double centring = std::max(rest * rest * rest, least_centring);
  if (aim == Aim::near_least_cost)
    correct_for(predictor);
  const Step corrector = direction(centring * mean);
  const Parts possible = longest(corrector, fraction_to_boundary);
  if (!(std::max(possible.of_forces, possible.of_displacements) >
        shortest_usable_step))
    return false;
  return take(corrector, possible);
}

/** Let the next step make up for what the linearisation leaves out. */
void InteriorPoint::correct_for(const Step &predictor)
{
  for (std::size_t k = 0; k < contacts.size(); ++k)
    contacts[k].second_order =
        predictor.contacts[k].p * predictor.contacts[k].z;
  for (unsigned int e = 0; e < states.size(); ++e)
    if (states[e].friction.exists())
      states[e].friction.correct_for(predictor.frictions[e]);
}

/** The forces that are missing to the balance of each body. */
std::vector<double> InteriorPoint::missing_forces() const
{
  std::vector<double> missing(problem.loads());
  for (double &load : missing)
    load *= alpha;
  problem.add_jump_gradients(-1., forces(), missing);
  return missing;
}

void InteriorPoint::find_shortages()
{
  for (unsigned int e = 0; e < states.size(); ++e)
  {
    State &state = states[e];
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r)
    {
      Contact &contact = contacts[problem.first_contact(e) + r];
      contact.short_z = problem.jump(e, r, displacement.data()) +
                        state.cost.normal_compliance * contact.p - contact.z;
    }
    state.short_v = problem.sliding(e, displacement.data()) -
                    state.cost.tangential_compliance * state.friction.force() -
                    state.friction.sliding();
  }
}

/** Linearise, and prepare the linear system. */
bool InteriorPoint::prepare()
{
  std::vector<double> &of_rows = stiffness.of_rows;
  stiffness.are_isotropic = true;
  for (unsigned int e = 0, k = 0; e < states.size(); ++e)
  {
    State &state = states[e];
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r, ++k)
    {
      const Contact &contact = contacts[problem.first_contact(e) + r];
      of_rows[k] =
          contact.p / (contact.z + state.normal_compliance() * contact.p);
    }
    of_rows[k] = 0.;
    if (state.friction.exists())
    {
      state.friction.linearise();
      of_rows[k] =
          1. / (state.friction.compliance() + state.cost.tangential_compliance +
                state.extra_compliance);
    }
    ++k;
    stiffness.are_isotropic &=
        is_isotropic(&of_rows[problem.first_row(e)], problem.n_contacts(e));
  }
  if (!std::all_of(of_rows.begin(), of_rows.end(),
                   [](const double k) { return std::isfinite(k); }))
    return false;
  double shift = least_shift;
  while (!system.prepare(stiffness, shift))
    if ((shift *= factor_of_shift) > largest_step_shift)
      return false;
  if (aim == Aim::load_factor)
    u_of_load = solve(problem.loads());
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
  const double enough = reduction_of_step * least;
  for (unsigned int k = 0; k < n_step_gradients && least > enough; ++k)
  {
    std::vector<double> z = system.solve(left);
    problem.remove_rigid_motions(z);
    const double now = dot(left, z);
    for (unsigned int i = 0; i < d.size(); ++i)
      d[i] = z[i] + now / previous * d[i];
    previous = now;

    std::vector<double> force(right.size(), 0.);
    long double energy = 0.;
    std::vector<double> f = problem.jumps(d);
    for (std::size_t k = 0; k < f.size(); ++k)
    {
      energy += stiffness.of_rows[k] * f[k] * f[k];
      f[k] *= stiffness.of_rows[k];
    }
    problem.add_jump_gradients(1., f, force);
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
  // The changes of -p and q are those below plus stiffness times [du].
  const std::vector<double> &k = stiffness.of_rows;
  std::vector<double> constant(k.size(), 0.);
  std::vector<double> right = missing_forces();
  for (unsigned int e = 0; e < states.size(); ++e)
  {
    const State &state = states[e];
    std::size_t row = problem.first_row(e);
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r, ++row)
    {
      const Contact &contact = contacts[problem.first_contact(e) + r];
      constant[row] =
          -k[row] *
          ((target * contact.weight - contact.second_order) / contact.p -
           contact.z - contact.short_z);
    }
    if (state.friction.exists())
      constant[row] = k[row] * (state.short_v -
                                state.friction.constant(target * state.weight));
  }
  problem.add_jump_gradients(-1., constant, right);
  Step step = {solve(right), {}, {}, 0.};
  if (aim == Aim::load_factor)
  {
    // The loads, at a factor of one, do the work one.
    step.load_factor =
        (1. - problem.work(displacement.data()) - problem.work(step.u.data())) /
        problem.work(u_of_load.data());
    for (unsigned int i = 0; i < step.u.size(); ++i)
      step.u[i] += step.load_factor * u_of_load[i];
  }
  const std::vector<double> jumps = problem.jumps(step.u);
  step.contacts.reserve(contacts.size());
  step.frictions.reserve(states.size());
  for (unsigned int e = 0; e < states.size(); ++e)
  {
    const State &state = states[e];
    std::size_t row = problem.first_row(e);
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r, ++row)
    {
      const Contact &contact = contacts[problem.first_contact(e) + r];
      const double dp = -constant[row] - k[row] * jumps[row];
      step.contacts.push_back(
          {dp, jumps[row] + contact.short_z + state.normal_compliance() * dp});
    }
    step.frictions.push_back(
        state.friction.exists()
            ? state.friction.step(target * state.weight,
                                  constant[row] + k[row] * jumps[row])
            : FrictionCone::Step{0., 0., 0., 0.});
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
  double of_forces = 1. / fraction, of_displacements = 1. / fraction;
  for (std::size_t k = 0; k < contacts.size(); ++k)
  {
    of_forces = std::min(of_forces, to_zero(contacts[k].p, step.contacts[k].p));
    of_displacements =
        std::min(of_displacements, to_zero(contacts[k].z, step.contacts[k].z));
  }
  for (unsigned int e = 0; e < states.size(); ++e)
    if (states[e].friction.exists())
    {
      const FrictionCone &friction = states[e].friction;
      of_forces =
          std::min(of_forces, friction.longest_of_force(step.frictions[e]));
      of_displacements = std::min(
          of_displacements, friction.longest_of_sliding(step.frictions[e]));
    }
  // A compliance ties displacements to forces.
  if (aim != Aim::load_factor)
    of_forces = of_displacements = std::min(of_forces, of_displacements);
  return {fraction * of_forces, fraction * of_displacements};
}

/** Take parts of a step, unless rounding has made it no number. */
bool InteriorPoint::take(const Step &step, const Parts &parts)
{
  const std::vector<State> states_before = states;
  const std::vector<Contact> contacts_before = contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k)
  {
    contacts[k].p += parts.of_forces * step.contacts[k].p;
    contacts[k].z += parts.of_displacements * step.contacts[k].z;
  }
  for (unsigned int e = 0; e < states.size(); ++e)
    states[e].friction.take(step.frictions[e], parts.of_forces,
                            parts.of_displacements);
  if (!std::isfinite(product()) || !std::isfinite(step.load_factor))
  {
    states = states_before;
    contacts = contacts_before;
    return false;
  }
  for (unsigned int i = 0; i < displacement.size(); ++i)
    displacement[i] += parts.of_displacements * step.u[i];
  alpha += parts.of_forces * step.load_factor;
  return true;
}

std::vector<double> InteriorPoint::forces() const
{
  std::vector<double> forces;
  forces.reserve(problem.n_all_rows());
  for (unsigned int e = 0; e < states.size(); ++e)
  {
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r)
      forces.push_back(-contacts[problem.first_contact(e) + r].p);
    forces.push_back(states[e].friction.force());
  }
  return forces;
}

double InteriorPoint::imbalance() const
{
  return largest_component(missing_forces());
}

double InteriorPoint::product() const
{
  double sum = 0.;
  unsigned int n = contacts.size();
  for (const Contact &contact : contacts)
    sum += contact.p * contact.z / contact.weight;
  for (const State &state : states)
    if (state.friction.exists())
    {
      sum += state.friction.product() / state.weight;
      ++n;
    }
  return sum / n;
}
} // namespace Voussoir
