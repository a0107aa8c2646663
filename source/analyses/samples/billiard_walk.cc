// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/samples/billiard_walk.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The mean time of a step. In the time one a force goes as far as it varies in
 * the ellipsoid. Measured, longer steps have more reflections for the same
 * effective number of samples, and shorter ones do not have less.
 */
constexpr double mean_time = 2.;
/** The reflections of a step, for each limit, after which it is not taken. */
constexpr unsigned int n_reflections = 100;
} // namespace

BilliardWalk::BilliardWalk(const StatePolytope &polytope,
                           const ExtremeStates &extremes,
                           const DikinEllipsoid &ellipsoid,
                           std::vector<double> start,
                           const unsigned int seed)
    : polytope(polytope), limits(extremes.limits()), ellipsoid(ellipsoid),
      balanced(polytope.problem()), random(seed), x(std::move(start)),
      direction(x.size())
{
  balanced.set_weights(ellipsoid.weights());
  for (const StatePolytope::Limit &limit : limits)
  {
    const unsigned int n_rows = limit.n_rows;
    double square = 0.;
    for (unsigned int r = 0; r < n_rows; ++r)
      for (unsigned int s = 0; s < n_rows; ++s)
        square += limit.outward[r] * limit.outward[s] *
                  ellipsoid.column(limit.first + r)[limit.first + s];
    squares.push_back(square);
  }
}

void BilliardWalk::find_direction()
{
  for (std::size_t r = 0; r < direction.size(); ++r)
    direction[r] = std::sqrt(ellipsoid.weights()[r]) * random.normal();
  balanced.balance(direction);
}

/** The place where all of the time goes. */
template <unsigned int n_rows>
BilliardWalk::Meeting BilliardWalk::next_limit() const
{
  Meeting next = {std::numeric_limits<double>::infinity(), 0};
  for (std::size_t k = 0; k < limits.size(); ++k)
  {
    const StatePolytope::Limit &limit = limits[k];
    const double *at = &x[limit.first], *to = &direction[limit.first];
    double room = limit.value, along = 0.;
    for (unsigned int r = 0; r < n_rows; ++r)
    {
      room -= limit.outward[r] * at[r];
      along += limit.outward[r] * to[r];
    }
    // False for a limit that it goes away from: the room is not negative.
    if (std::max(room, 0.) < next.time * along)
      next = {std::max(room, 0.) / along, k};
  }
  return next;
}

/** Turn the direction back, of which @p size is along the normal. */
void BilliardWalk::reflect(const StatePolytope::Limit &limit, const double size)
{
  for (unsigned int r = 0; r < limit.n_rows; ++r)
  {
    const double factor = 2. * size * limit.outward[r];
    if (factor == 0.)
      continue;
    const double *column = ellipsoid.column(limit.first + r);
    for (std::size_t k = 0; k < direction.size(); ++k)
      direction[k] -= factor * column[k];
  }
}

void BilliardWalk::step()
{
  find_direction();
  double time = -mean_time * std::log(1. - random());
  const std::vector<double> start = x;
  for (std::size_t k = 0; k < n_reflections * limits.size(); ++k)
  {
    const Meeting next =
        limits.front().n_rows == 2 ? next_limit<2>() : next_limit<3>();
    add(x, std::min(time, next.time), direction);
    if (next.time >= time)
      return;
    time -= next.time;
    const StatePolytope::Limit &limit = limits[next.limit];
    reflect(limit, polytope.along(limit, direction) / squares[next.limit]);
  }
  // The way back would not be taken either.
  x = start;
}

void BilliardWalk::go(const unsigned int n)
{
  for (unsigned int k = 0; k < n; ++k)
    step();
  // Rounding adds up.
  balanced.balance_loads(x);
}
} // namespace Voussoir
