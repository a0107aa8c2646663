// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
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

/** The largest component that is judged, on all processes. */
double largest(const Structure &structure, const std::vector<double> &v)
{
  double size = 0.;
  for (unsigned int k = 0; k < structure.n_judged_dofs(); ++k)
    size = std::max(size, std::abs(v[k]));
  return structure.processes().max(size);
}

/** The product over own bodies, on all processes. */
double product(const Structure &structure,
               const std::vector<double> &a,
               const std::vector<double> &b)
{
  long double sum = 0.;
  for (unsigned int k = 0; k < structure.n_own_dofs(); ++k)
    sum += a[k] * b[k];
  return static_cast<double>(structure.processes().sum(sum));
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
  restart(std::move(u));
}

void Newton::restart(std::vector<double> u)
{
  present.u = std::move(u);
  present.jumps = structure.jumps(present.u);
  evaluate(present);
}

void Newton::evaluate(State &state)
{
  ++evaluations;
  state.forces.resize(structure.n_all_rows());
  state.gradient.resize(structure.n_dofs());
  for (unsigned int k = 0; k < structure.n_own_dofs(); ++k)
    state.gradient[k] = -structure.loads()[k];
  for (unsigned int e = 0; e < structure.joints().size(); ++e)
    law.find_forces(e, state.jumps.data() + structure.first_row(e),
                    state.forces.data() + structure.first_row(e));
  structure.add_jump_gradients(1., state.forces, state.gradient);
}

double Newton::step(const double shift, const std::vector<double> &centre)
{
  ++iterations;
  return search(direction(shift, centre), shift, centre);
}

void Newton::full_step()
{
  ++iterations;
  const Direction d = direction(least_shift, present.u);
  State trial;
  go(d, std::min(1., d.longest), trial);
  accept(std::move(trial));
}

Newton::Direction Newton::direction(const double shift,
                                    const std::vector<double> &centre)
{
  std::vector<double> right(present.gradient.size());
  for (unsigned int k = 0; k < right.size(); ++k)
    right[k] =
        proximal_force(shift, present.u[k], centre[k]) - present.gradient[k];
  Direction d;
  d.u = solve(shift, right);
  d.jumps = structure.jumps(d.u);
  double longest = longest_expansion / fraction_to_boundary;
  for (unsigned int e = 0; e < structure.joints().size(); ++e)
    longest = std::min(
        longest, law.longest_step(e, &present.jumps[structure.first_row(e)],
                                  &d.jumps[structure.first_row(e)]));
  d.longest = fraction_to_boundary * structure.processes().min(longest);
  return d;
}

JointStiffnesses Newton::stiffnesses() const
{
  JointStiffnesses second = {
      std::vector<double>(structure.n_all_coefficients()), true};
  for (unsigned int e = 0; e < structure.joints().size(); ++e)
    second.are_isotropic &= law.find_second_derivatives(
        e, &present.jumps[structure.first_row(e)],
        &second.of_rows[structure.first_coefficient(e)]);
  const bool finite =
      std::all_of(second.of_rows.begin(), second.of_rows.end(),
                  [](const double k) { return std::isfinite(k); });
  if (!structure.processes().all(finite))
    throw NewtonFailure(NewtonFailure::Cause::stiffness);
  return second;
}

std::vector<double> Newton::solve(double shift,
                                  const std::vector<double> &right)
{
  const JointStiffnesses second = stiffnesses();
  double stiffest = 1.;
  for (const double k : second.of_rows)
    stiffest = std::max(stiffest, k);
  stiffest = structure.processes().max(stiffest);
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
  throw NewtonFailure(NewtonFailure::Cause::linear_system);
}

/**
 * Take out of @p d what the shift has put into it, where that is little: cells
 * that no joint holds owe their whole displacement to the shift.
 */
void Newton::refine(const JointStiffnesses &second,
                    const std::vector<double> &right,
                    std::vector<double> &d)
{
  std::vector<double> left(right);
  std::vector<double> f = structure.jumps(d);
  structure.multiply_by_blocks(second.of_rows, f);
  structure.add_jump_gradients(-1., f, left);
  if (largest(structure, left) > little_left * largest(structure, right))
    return;
  const std::vector<double> correction = system.solve(left);
  for (unsigned int k = 0; k < d.size(); ++k)
    d[k] += correction[k];
}

/** It goes there: trial is the state at the last length asked for. */
class Newton::Slope
{
public:
  Slope(Newton &newton,
        const Direction &direction,
        const double shift,
        const std::vector<double> &centre)
      : newton(newton), direction(direction), shift(shift), centre(centre)
  {}
  double operator()(const double t)
  {
    length = t;
    newton.go(direction, t, trial);
    const double slope = of(trial);
    return std::isfinite(slope) ? slope : std::numeric_limits<double>::max();
  }
  double of(const State &state) const
  {
    long double sum = 0.;
    for (unsigned int k = 0; k < newton.structure.n_own_dofs(); ++k)
      sum +=
          (state.gradient[k] - proximal_force(shift, state.u[k], centre[k])) *
          direction.u[k];
    return static_cast<double>(newton.structure.processes().sum(sum));
  }

  State trial;
  double length = 0.;

private:
  Newton &newton;
  const Direction &direction;
  const double shift;
  const std::vector<double> &centre;
};

double Newton::search(const Direction &direction,
                      const double shift,
                      const std::vector<double> &centre)
{
  Slope slope(*this, direction, shift, centre);
  double lower = 0., slope_lower = slope.of(present);
  last_decrement = slope_lower <= 0. ? std::sqrt(-slope_lower)
                                     : std::numeric_limits<double>::infinity();
  const double small = slope_reduction * std::abs(slope_lower);
  double upper = std::min(1., direction.longest);
  double slope_upper = slope(upper);
  while (slope_upper < -small && upper < direction.longest)
  {
    lower = upper;
    slope_lower = slope_upper;
    upper = std::min(expansion * upper, direction.longest);
    slope_upper = slope(upper);
  }
  // In the limit of rounding there may be no change of sign to be found.
  if (slope_upper > small && slope_lower < 0.)
  {
    bool found = false;
    std::uintmax_t n_searches = n_max_searches;
    boost::math::tools::toms748_solve(
        [&](const double at) {
          const double s = found ? 0. : slope(at);
          found = found || std::abs(s) <= small;
          return found ? 0. : s;
        },
        lower, upper, slope_lower, slope_upper,
        [&](const double a, const double b) {
          return found || b - a <= smallest_bracket * b;
        },
        n_searches);
  }
  accept(std::move(slope.trial));
  return slope.length;
}

void Newton::go(const Direction &direction, const double t, State &trial)
{
  trial.u = present.u;
  for (unsigned int k = 0; k < trial.u.size(); ++k)
    trial.u[k] += t * direction.u[k];
  trial.jumps = present.jumps;
  for (std::size_t k = 0; k < trial.jumps.size(); ++k)
    trial.jumps[k] += t * direction.jumps[k];
  evaluate(trial);
}

void Newton::accept(State trial)
{
  last_force_change = 0.;
  for (std::size_t k = 0; k < trial.forces.size(); ++k)
    last_force_change = std::max(last_force_change,
                                 std::abs(trial.forces[k] - present.forces[k]));
  last_force_change = structure.processes().max(last_force_change);
  present = std::move(trial);
}

double Newton::imbalance() const
{
  return largest(structure, present.gradient);
}

double Newton::imbalance(const double shift,
                         const std::vector<double> &centre) const
{
  double largest = 0.;
  for (unsigned int k = 0; k < structure.n_judged_dofs(); ++k)
    largest = std::max(largest,
                       std::abs(proximal_force(shift, present.u[k], centre[k]) -
                                present.gradient[k]));
  return structure.processes().max(largest);
}

} // namespace Voussoir
