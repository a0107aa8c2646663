// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/conic/bounded_forces.h>

#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/** The relative shifts of the diagonal: the first, the factor to the next. */
constexpr double first_shift_of_forces = 1e-14, factor_of_force_shift = 100.,
                 largest_force_shift = 1e-2;

/** The steps of conjugate gradients that may bring nothing. */
constexpr unsigned int n_without_gain = 3;
} // namespace

BoundedForces::BoundedForces(const BoundedRows &rows, std::vector<bool> held)
    : rows(rows), held(std::move(held)),
      factor(JointBlocks(rows, false), rows.n_bodies(), {}, this->held)
{
  for (unsigned int r = 0; r < rows.n_all_rows(); ++r)
  {
    const BoundedRows::Bounds &of_row = rows.bounds()[r];
    if (of_row.least == 0. && of_row.greatest == 0.)
    {
      without_force.push_back(r);
      continue;
    }
    if (std::isfinite(of_row.greatest))
      all_bounds.push_back({r, 1., of_row.greatest});
    if (std::isfinite(of_row.least))
      all_bounds.push_back({r, -1., -of_row.least});
  }
}

BoundedForces::BoundedForces(const BoundedRows &rows,
                             std::vector<bool> held,
                             const std::vector<double> &c)
    : BoundedForces(rows, std::move(held))
{
  for (unsigned int r = 0; r < c.size(); ++r)
    if (c[r] != 0.)
      of_function.push_back({r, c[r]});
}

void BoundedForces::clear_held(std::vector<double> &loads) const
{
  for (unsigned int b = 0; b < held.size(); ++b)
    if (held[b])
      for (unsigned int i = 0; i < rows.n_unknowns(); ++i)
        loads[rows.dof(b, i)] = 0.;
}

std::vector<double> BoundedForces::on_bodies(const std::vector<double> &x) const
{
  std::vector<double> sum(n_unknowns(), 0.);
  rows.add_jump_gradients(-1., x, sum);
  clear_held(sum);
  for (const auto &[row, c] : of_function)
    sum.back() += c * x[row];
  return sum;
}

std::vector<double> BoundedForces::along(const std::vector<double> &u) const
{
  std::vector<double> result = rows.jumps(u);
  for (double &jump : result)
    jump = -jump;
  for (const auto &[row, c] : of_function)
    result[row] += c * u.back();
  for (const unsigned int row : without_force)
    result[row] = 0.;
  return result;
}

std::vector<double> BoundedForces::at_bounds(const std::vector<double> &x) const
{
  std::vector<double> result;
  result.reserve(all_bounds.size());
  for (const Bound &bound : all_bounds)
    result.push_back(bound.sign * x[bound.row]);
  return result;
}

std::vector<double> BoundedForces::of_rows(const std::vector<double> &z) const
{
  std::vector<double> result(rows.n_all_rows(), 0.);
  for (std::size_t b = 0; b < z.size(); ++b)
    result[all_bounds[b].row] += all_bounds[b].sign * z[b];
  return result;
}

std::vector<double>
BoundedForces::inverse_sums(const std::vector<double> &weights) const
{
  std::vector<double> result(rows.n_all_rows(), 0.);
  for (std::size_t b = 0; b < weights.size(); ++b)
    result[all_bounds[b].row] += weights[b];
  for (double &sum : result)
    if (sum > 0.)
      sum = 1. / sum;
  return result;
}

bool BoundedForces::prepare(std::vector<double> k)
{
  weights = std::move(k);
  for (const double weight : weights)
    if (!std::isfinite(weight))
      return false;
  for (double shift = first_shift_of_forces; shift <= largest_force_shift;
       shift *= factor_of_force_shift)
    if (factorise(shift))
      return true;
  return false;
}

bool BoundedForces::factorise(const double shift)
{
  if (of_function.empty())
    return factor.factorise(weights, 0., shift);

  own_stiffness = 0.;
  std::vector<double> rest = weights, of_rows(weights.size(), 0.);
  for (const auto &[row, c] : of_function)
  {
    own_stiffness += c * c * weights[row];
    of_rows[row] = c * weights[row];
    rest[row] = 0.;
  }
  if (!(own_stiffness > 0.))
    return false;
  coupling = on_bodies(of_rows);
  coupling.pop_back();
  std::vector<SparseFactor::FurtherRow> further;
  for (std::size_t i = 0; i < of_function.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
    {
      const auto &[r, c_r] = of_function[i];
      const auto &[s, c_s] = of_function[j];
      const unsigned int e = rows.joint_of_row(r);
      further.push_back({e, combination(c_s, rows.row(r), -c_r, rows.row(s)),
                         weights[r] * (weights[s] / own_stiffness)});
    }
  return factor.factorise(rest, 0., shift, further);
}

std::vector<double>
BoundedForces::precondition(const std::vector<double> &right)
{
  if (of_function.empty())
    return factor.solve(right, 1);
  std::vector<double> left(right.begin(), right.end() - 1);
  add(left, -right.back() / own_stiffness, coupling);
  std::vector<double> u = factor.solve(left, 1);
  u.push_back((right.back() - dot(coupling, u)) / own_stiffness);
  return u;
}

std::vector<double> BoundedForces::product(const std::vector<double> &u) const
{
  std::vector<double> x = along(u);
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] *= weights[k];
  return on_bodies(x);
}

std::vector<double> BoundedForces::solve(const std::vector<double> &right,
                                         const double enough,
                                         const unsigned int n_gradients)
{
  std::vector<double> u = precondition(right), best = u;
  std::vector<double> left = right;
  add(left, -1., product(u));
  double least = largest_component(left), previous = 0.;
  std::vector<double> direction;
  unsigned int n_in_vain = 0;
  for (unsigned int k = 0;
       k < n_gradients && least > enough && n_in_vain < n_without_gain; ++k)
  {
    const std::vector<double> z = precondition(left);
    const double now = dot(left, z);
    if (direction.empty())
      direction = z;
    else
      for (std::size_t i = 0; i < z.size(); ++i)
        direction[i] = z[i] + now / previous * direction[i];
    previous = now;
    const std::vector<double> force = product(direction);
    const double energy = dot(direction, force);
    if (!(energy > 0.) || !(now > 0.))
      break;
    add(u, now / energy, direction);
    add(left, -now / energy, force);
    ++n_in_vain;
    if (const double size = largest_component(left); size < least)
    {
      best = u;
      least = size;
      n_in_vain = 0;
    }
  }
  return best;
}
} // namespace Voussoir
