// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/samples/dikin_ellipsoid.h>
#include <voussoir/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/** What forces may leave on a body, and how often that is improved. */
constexpr double enough = 1e-14;
constexpr unsigned int n_centre_gradients = 10;
/** Newton's steps to the centre: their number, and the last one's decrement. */
constexpr unsigned int n_centre_steps = 100;
constexpr double small_decrement = 1e-3;
/** The share of the way to a limit that a step may go. */
constexpr double share_of_way_to_boundary = 0.9;
/** The least decrease of the barrier, over that of its tangent. */
constexpr double least_decrease = 0.1;
constexpr double shortest_centre_step = 1e-6;
/** The units of numbers whose last digits are cut off. */
constexpr double digits_of_weights = 256., digits_of_forces = 65536.;

/** @p number with its first eight binary digits. */
double rounded(const double number)
{
  int exponent = 0;
  const double mantissa = std::frexp(number, &exponent);
  return std::ldexp(
      std::round(digits_of_weights * mantissa) / digits_of_weights, exponent);
}

/** The barrier -sum log(room) of the limits that cut a polytope out. */
class Barrier
{
public:
  Barrier(const StatePolytope &polytope, const ExtremeStates &extremes)
      : polytope(polytope), limits(extremes.limits())
  {}
  double operator()(const std::vector<double> &x) const
  {
    double sum = 0.;
    for (const StatePolytope::Limit &limit : limits)
    {
      const double room = polytope.room(limit, x);
      if (!(room > 0.))
        return std::numeric_limits<double>::infinity();
      sum -= std::log(room);
    }
    return sum;
  }
  std::vector<double> gradient(const std::vector<double> &x) const
  {
    return sums(x, 1);
  }
  /** The diagonal of the second derivatives. */
  std::vector<double> diagonal(const std::vector<double> &x) const
  {
    return sums(x, 2);
  }
  /** The longest step along @p d, at most one. */
  double longest(const std::vector<double> &x,
                 const std::vector<double> &d) const
  {
    double step = 1.;
    for (const StatePolytope::Limit &limit : limits)
      if (const double along = polytope.along(limit, d); along > 0.)
        step = std::min(step, share_of_way_to_boundary *
                                  polytope.room(limit, x) / along);
    return step;
  }

private:
  /** The sums of (outward / room)^power of each force. */
  std::vector<double> sums(const std::vector<double> &x, const int power) const
  {
    std::vector<double> result(x.size(), 0.);
    for (const StatePolytope::Limit &limit : limits)
    {
      const double room = polytope.room(limit, x);
      for (unsigned int r = 0; r < limit.n_rows; ++r)
        result[limit.first + r] += std::pow(limit.outward[r] / room, power);
    }
    return result;
  }

  const StatePolytope &polytope;
  const std::vector<StatePolytope::Limit> &limits;
};
} // namespace

BalancedForces::BalancedForces(const DiscreteProblem &problem)
    : by_rows(problem), loads(by_rows.loads())
{
  by_rows.forces().avoid_blas();
}

void BalancedForces::set_weights(std::vector<double> of_forces)
{
  weights = std::move(of_forces);
  if (!by_rows.forces().prepare_diagonal(weights))
    throw SolverError("No directions for 'Ranges/Samples' were found: forces "
                      "of very different sizes spoil the digits. Set "
                      "'Ranges/Samples = 0'.");
}

/** Subtract from @p x what adds up to @p imbalance. */
void BalancedForces::subtract(const std::vector<double> &imbalance,
                              std::vector<double> &x) const
{
  const std::vector<double> along = by_rows.forces().along(
      by_rows.forces().solve(imbalance, 0., enough, n_centre_gradients).u);
  for (std::size_t r = 0; r < x.size(); ++r)
    x[r] -= weights[r] * along[r];
}

void BalancedForces::balance(std::vector<double> &x) const
{
  subtract(by_rows.forces().on_bodies(x), x);
}

void BalancedForces::balance_loads(std::vector<double> &x) const
{
  std::vector<double> imbalance = by_rows.forces().on_bodies(x);
  add(imbalance, 1., loads);
  by_rows.forces().clear_held(imbalance);
  subtract(imbalance, x);
}

DikinEllipsoid::DikinEllipsoid(const StatePolytope &polytope,
                               const ExtremeStates &extremes)
    : n(polytope.n_forces()), balanced(polytope.problem())
{
  find_centre(polytope, extremes);
  balanced.set_weights(inverse);
  x = towards(x, 0.);
  find_columns();
}

/**
 * Find the centre, and there the weights. Their digits are few, so that others
 * than those of rounding decide: what an interior point or a linear programme
 * has for its last digits does not matter.
 */
void DikinEllipsoid::find_centre(const StatePolytope &polytope,
                                 const ExtremeStates &extremes)
{
  const Barrier barrier(polytope, extremes);
  const auto find_inverse = [&] {
    inverse = barrier.diagonal(x);
    for (std::size_t r = 0; r < n; ++r)
      inverse[r] = extremes.varies()[r] ? rounded(1. / inverse[r]) : 0.;
  };
  x = extremes.middle();
  for (unsigned int k = 0; k < n_centre_steps; ++k)
  {
    find_inverse();
    balanced.set_weights(inverse);
    const std::vector<double> gradient = barrier.gradient(x);
    std::vector<double> direction(n);
    for (std::size_t r = 0; r < n; ++r)
      direction[r] = -inverse[r] * gradient[r];
    balanced.balance(direction);
    const double decrement = -dot(gradient, direction);
    if (!(decrement > small_decrement))
      break;
    const double before = barrier(x);
    double step = barrier.longest(x, direction);
    std::vector<double> next = x;
    add(next, step, direction);
    while (barrier(next) > before - least_decrease * step * decrement &&
           step > shortest_centre_step)
    {
      step *= 0.5;
      next = x;
      add(next, step, direction);
    }
    x = std::move(next);
  }
  find_inverse();
}

void DikinEllipsoid::find_columns()
{
  columns.assign(n * n, 0.);
  for (std::size_t r = 0; r < n; ++r)
  {
    if (inverse[r] == 0.)
      continue;
    std::vector<double> column(n, 0.);
    column[r] = inverse[r];
    balanced.balance(column);
    std::copy(column.begin(), column.end(), columns.begin() + r * n);
  }
}

std::vector<double> DikinEllipsoid::towards(const std::vector<double> &to,
                                            const double share) const
{
  std::vector<double> state = x;
  for (std::size_t r = 0; r < n; ++r)
  {
    // Of forces that do not vary, any state has the right ones.
    const double unit = std::sqrt(inverse[r]) / digits_of_forces;
    if (unit > 0.)
      state[r] = unit * std::round((x[r] + share * (to[r] - x[r])) / unit);
  }
  balanced.balance_loads(state);
  return state;
}
} // namespace Voussoir
