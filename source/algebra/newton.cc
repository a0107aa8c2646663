// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/exceptions.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
using Jump = Structure::Jump;

namespace
{
/** The slope at the end of a line search, relative to that at its beginning. */
constexpr double slope_reduction = 0.1;
/** The part of the way to the end of the energy's domain that is allowed. */
constexpr double fraction_to_boundary = 0.99;
/** The growth of a step while the energy falls, and its limit. */
constexpr double expansion = 8.;
constexpr double longest_expansion = 1e8;
constexpr unsigned int n_max_searches = 60;
/** The width of the bracket, relative to its end, that cannot be halved. */
constexpr double smallest_bracket = 1e-15;

/** The largest residual that refine() corrects, over the right-hand side. */
constexpr double little_left = 1e-3;

/** The largest component of an own body, on all processes. */
double largest(const Structure &structure, const std::vector<double> &v)
{
  double size = 0.;
  for (unsigned int k = 0; k < structure.n_own_dofs(); ++k)
    size = std::max(size, std::abs(v[k]));
  return structure.team().max(size);
}

/** The product over own bodies, on all processes. */
double product(const Structure &structure,
               const std::vector<double> &a,
               const std::vector<double> &b)
{
  long double sum = 0.;
  for (unsigned int k = 0; k < structure.n_own_dofs(); ++k)
    sum += a[k] * b[k];
  return static_cast<double>(structure.team().sum(sum));
}

double proximal_force(const double shift, const double u, const double centre)
{
  return -shift * (u - centre);
}
} // namespace

Newton::Newton(const Structure &structure,
               const JointLaw &law,
               JointSystem &system,
               std::vector<double> u)
    : structure(structure), law(law), system(system),
      last_decrement(std::numeric_limits<double>::infinity()),
      last_force_change(std::numeric_limits<double>::infinity())
{
  present.u = std::move(u);
  present.jumps = jumps_of(present.u);
  evaluate(present);
}

std::vector<Jump> Newton::jumps_of(const std::vector<double> &u) const
{
  std::vector<Jump> jumps(structure.joints().size());
  for (unsigned int e = 0; e < jumps.size(); ++e)
    jumps[e] = structure.jump(structure.joints()[e], u.data());
  return jumps;
}

void Newton::evaluate(State &state)
{
  ++evaluations;
  const auto &joints = structure.joints();
  state.forces.resize(joints.size());
  state.gradient.resize(structure.n_dofs());
  for (unsigned int b = 0; b < structure.n_own_bodies(); ++b)
    for (unsigned int i = 0; i < 2; ++i)
      state.gradient[structure.dof(b, i)] = -structure.loads()[b][i];
  for (unsigned int e = 0; e < joints.size(); ++e)
  {
    state.forces[e] = law.force(e, state.jumps[e]);
    structure.add_jump_gradient(joints[e], state.forces[e],
                                state.gradient.data());
  }
}

double Newton::step(const double shift, const std::vector<double> &centre)
{
  ++iterations;
  return search(direction(shift, centre), shift, centre);
}

void Newton::full_step()
{
  ++iterations;
  const std::vector<double> d = direction(least_shift, present.u);
  const std::vector<Jump> step_jumps = jumps_of(d);
  State trial;
  go(d, step_jumps, std::min(1., longest_step(step_jumps)), trial);
  accept(std::move(trial));
}

/** The longest step with finite energy, with a margin. */
double Newton::longest_step(const std::vector<Jump> &step_jumps) const
{
  double longest = longest_expansion / fraction_to_boundary;
  for (unsigned int e = 0; e < step_jumps.size(); ++e)
    longest =
        std::min(longest, law.longest_step(e, present.jumps[e], step_jumps[e]));
  return fraction_to_boundary * structure.team().min(longest);
}

std::vector<double> Newton::direction(double shift,
                                      const std::vector<double> &centre)
{
  std::vector<double> right(present.gradient.size());
  for (unsigned int k = 0; k < right.size(); ++k)
    right[k] =
        proximal_force(shift, present.u[k], centre[k]) - present.gradient[k];

  std::vector<Jump> second(present.jumps.size());
  double stiffest = 1.;
  bool finite = true;
  for (unsigned int e = 0; e < second.size(); ++e)
  {
    second[e] = law.second_derivative(e, present.jumps[e]);
    stiffest = std::max({stiffest, second[e].normal, second[e].tangential});
    finite &= std::isfinite(second[e].normal + second[e].tangential);
  }
  stiffest = structure.team().max(stiffest);
  if (!structure.team().all(finite))
    throw SolverError("The stiffness of a joint is beyond all numbers: its "
                      "strength is too far above the load. Lower "
                      "'Friction/Strength', or take another 'Formulation'.");
  // Rounding can cost the matrix its definiteness; then the step would not lead
  // downhill, and a larger shift is tried, up to the largest coefficient.
  for (; shift <= stiffest; shift *= factor_of_shift)
    if (system.prepare(second, shift))
    {
      std::vector<double> d = system.solve(right);
      if (shift == least_shift && system.is_direct())
        refine(second, right, d);
      const double descent = product(structure, right, d);
      if (std::isfinite(descent) && descent >= 0.)
        return d;
    }
  throw SolverError(
      "A linear system of Newton's method cannot be solved: the strengths or "
      "the sizes of the interfaces differ by too much. Take another "
      "'Formulation'.");
}

/**
 * Take out of @p d what the shift has put into it, where that is little: cells
 * that no joint holds owe their whole displacement to the shift.
 */
void Newton::refine(const std::vector<Jump> &second,
                    const std::vector<double> &right,
                    std::vector<double> &d)
{
  std::vector<double> left(right);
  for (unsigned int e = 0; e < second.size(); ++e)
  {
    const Jump jump = structure.jump(structure.joints()[e], d.data());
    structure.add_jump_gradient(structure.joints()[e],
                                {-second[e].normal * jump.normal,
                                 -second[e].tangential * jump.tangential},
                                left.data());
  }
  if (largest(structure, left) > little_left * largest(structure, right))
    return;
  const std::vector<double> correction = system.solve(left);
  for (unsigned int k = 0; k < d.size(); ++k)
    d[k] += correction[k];
}

double Newton::search(const std::vector<double> &direction,
                      const double shift,
                      const std::vector<double> &centre)
{
  const auto slope = [&](const State &state) {
    long double sum = 0.;
    for (unsigned int k = 0; k < structure.n_own_dofs(); ++k)
      sum +=
          (state.gradient[k] - proximal_force(shift, state.u[k], centre[k])) *
          direction[k];
    return static_cast<double>(structure.team().sum(sum));
  };

  const std::vector<Jump> step_jumps = jumps_of(direction);
  const double longest = longest_step(step_jumps);

  State trial;
  double t = 0.;
  const auto slope_at = [&](const double at) {
    t = at;
    go(direction, step_jumps, t, trial);
    const double s = slope(trial);
    return std::isfinite(s) ? s : std::numeric_limits<double>::max();
  };

  double lower = 0., slope_lower = slope(present);
  last_decrement = slope_lower <= 0. ? std::sqrt(-slope_lower)
                                     : std::numeric_limits<double>::infinity();
  const double small = slope_reduction * std::abs(slope_lower);
  double upper = std::min(1., longest);
  double slope_upper = slope_at(upper);
  while (slope_upper < -small && upper < longest)
  {
    lower = upper;
    slope_lower = slope_upper;
    upper = std::min(expansion * upper, longest);
    slope_upper = slope_at(upper);
  }
  // In the limit of rounding there may be no change of sign to be found.
  if (slope_upper > small && slope_lower < 0.)
  {
    bool found = false;
    std::uintmax_t n_searches = n_max_searches;
    boost::math::tools::toms748_solve(
        [&](const double at) {
          if (found)
            return 0.;
          const double s = slope_at(at);
          found = std::abs(s) <= small;
          return found ? 0. : s;
        },
        lower, upper, slope_lower, slope_upper,
        [&](const double a, const double b) {
          return found || b - a <= smallest_bracket * b;
        },
        n_searches);
  }
  accept(std::move(trial));
  return t;
}

void Newton::go(const std::vector<double> &direction,
                const std::vector<Jump> &step_jumps,
                const double t,
                State &trial)
{
  trial.u = present.u;
  for (unsigned int k = 0; k < direction.size(); ++k)
    trial.u[k] += t * direction[k];
  trial.jumps = present.jumps;
  for (unsigned int e = 0; e < step_jumps.size(); ++e)
  {
    trial.jumps[e].normal += t * step_jumps[e].normal;
    trial.jumps[e].tangential += t * step_jumps[e].tangential;
  }
  evaluate(trial);
}

void Newton::accept(State trial)
{
  last_force_change = 0.;
  for (unsigned int e = 0; e < trial.forces.size(); ++e)
    last_force_change = std::max(
        {last_force_change,
         std::abs(trial.forces[e].normal - present.forces[e].normal),
         std::abs(trial.forces[e].tangential - present.forces[e].tangential)});
  last_force_change = structure.team().max(last_force_change);
  present = std::move(trial);
}

const std::vector<double> &Newton::u() const
{
  return present.u;
}

const std::vector<Jump> &Newton::jumps() const
{
  return present.jumps;
}

const std::vector<Jump> &Newton::forces() const
{
  return present.forces;
}

double Newton::imbalance() const
{
  return imbalance(0., present.u);
}

double Newton::imbalance(const double shift,
                         const std::vector<double> &centre) const
{
  double largest = 0.;
  for (unsigned int k = 0; k < structure.n_own_dofs(); ++k)
    largest = std::max(largest,
                       std::abs(proximal_force(shift, present.u[k], centre[k]) -
                                present.gradient[k]));
  return structure.team().max(largest);
}

double Newton::decrement() const
{
  return last_decrement;
}

double Newton::force_change() const
{
  return last_force_change;
}

unsigned int Newton::n_iterations() const
{
  return iterations;
}

unsigned int Newton::n_evaluations() const
{
  return evaluations;
}

double Newton::seconds_of_systems() const
{
  return system.seconds();
}
} // namespace Voussoir
