// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/conic/conic_forces.h>

#include <algorithm>
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
constexpr unsigned int n_without_gain = 10;

/** The cone N^2 <= 2 f |e| p_k of one end of a section. */
ConicForces::Cone cone_of(const ForceRows::Section &section,
                          const unsigned int end)
{
  // (a + g p)^2 - (a - g p)^2 = 4 a g p = 2 f |e| p, where p is minus the
  // force, and of order one: g lets the two have the same size.
  const double g = std::max(1., std::sqrt(0.5 * section.strength));
  const double a = 0.5 * section.strength / g;
  ConicForces::Cone cone = {section.row, {{a, -a, 0.}}, {}};
  cone.b[0][end] = cone.b[1][end] = g;
  cone.b[2] = {{1., 1.}};
  return cone;
}

/** The cone of an arc. */
ConicForces::Cone cone_of(const ForceRows::Arc &arc)
{
  return {arc.row,
          {{arc.strength, 0., 0.}},
          {{{{0., 0.}}, {{-1., 0.}}, {{0., -1.}}}}};
}

/**
 * A positive sum of squares c (g . x)^2 of two rows, and its inverse, to all
 * digits however different the c are.
 */
class SumOfSquares
{
public:
  void add(const double c, const std::array<double, 2> &g)
  {
    for (const Square &other : squares)
    {
      const double volume = g[0] * other.g[1] - g[1] * other.g[0];
      det += c * other.c * (volume * volume);
    }
    squares.push_back({c, g});
  }
  /** The three different entries of the inverse: 00, 01, 11. */
  std::array<double, 3> inverse() const
  {
    std::array<double, 3> sum = {};
    for (const Square &square : squares)
    {
      const double weight = square.c / det;
      sum[0] += weight * square.g[1] * square.g[1];
      sum[1] -= weight * square.g[0] * square.g[1];
      sum[2] += weight * square.g[0] * square.g[0];
    }
    return sum;
  }

private:
  struct Square
  {
    double c;
    std::array<double, 2> g;
  };
  std::vector<Square> squares;
  double det = 0.;
};

/** B^T v of one cone. */
std::array<double, 2> transposed(const ConicForces::Cone &cone,
                                 const QuadraticCone::Vector &v)
{
  std::array<double, 2> sum = {};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      sum[j] += cone.b[i][j] * v[i];
  return sum;
}

/**
 * Add B^T W^-2 B of one cone: 2 w w^T - J. Of -B^T J B the head is nothing in
 * an arc, and in a section what the first of the tail is.
 */
void add_cone(const ConicForces::Cone &cone,
              const QuadraticCone::Scaling &scaling,
              SumOfSquares &sum)
{
  const QuadraticCone::Vector &w = scaling.w;
  sum.add(2. / scaling.eta_squared, transposed(cone, {{w[0], -w[1], -w[2]}}));
  sum.add(1. / scaling.eta_squared, cone.b[2]);
  if (cone.b[0] != cone.b[1])
    sum.add(1. / scaling.eta_squared, cone.b[1]);
}
} // namespace

ConicForces::ConicForces(const ForceRows &rows,
                         std::vector<bool> held,
                         std::vector<double> curvature)
    : rows(rows), held(std::move(held)), of_cost(std::move(curvature)),
      factor(JointBlocks(rows, false), rows.n_bodies(), {}, this->held)
{
  for (unsigned int r = 0; r < rows.n_all_rows(); ++r)
  {
    const ForceRows::Bounds &of_row = rows.bounds()[r];
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
  for (const ForceRows::Section &section : rows.sections())
    for (unsigned int end = 0; end < 2; ++end)
      all_cones.push_back(cone_of(section, end));
  for (const ForceRows::Arc &arc : rows.arcs())
    all_cones.push_back(cone_of(arc));
  // In the order of the rows, as sets are gone through.
  std::stable_sort(all_cones.begin(), all_cones.end(),
                   [](const Cone &a, const Cone &b) { return a.row < b.row; });
}

void ConicForces::clear_held(std::vector<double> &loads) const
{
  for (unsigned int b = 0; b < held.size(); ++b)
    if (held[b])
      for (unsigned int i = 0; i < rows.n_unknowns(); ++i)
        loads[rows.dof(b, i)] = 0.;
}

QuadraticCone::Vector ConicForces::of_cone(const std::vector<double> &v,
                                           const std::size_t cone) const
{
  const double *of = &v[all_bounds.size() + 3 * cone];
  return {{of[0], of[1], of[2]}};
}

void ConicForces::set_cone(std::vector<double> &v,
                           const std::size_t cone,
                           const QuadraticCone::Vector &value) const
{
  std::copy(value.begin(), value.end(),
            v.begin() + (all_bounds.size() + 3 * cone));
}

std::vector<double> ConicForces::limits() const
{
  std::vector<double> h;
  h.reserve(n_slacks());
  for (const Bound &bound : all_bounds)
    h.push_back(bound.limit);
  for (const Cone &cone : all_cones)
    h.insert(h.end(), cone.limit.begin(), cone.limit.end());
  return h;
}

std::vector<double> ConicForces::on_bodies(const std::vector<double> &x) const
{
  std::vector<double> sum(rows.n_dofs(), 0.);
  rows.add_jump_gradients(-1., x, sum);
  clear_held(sum);
  return sum;
}

std::vector<double> ConicForces::along(const std::vector<double> &u) const
{
  std::vector<double> result = rows.jumps(u);
  for (double &jump : result)
    jump = -jump;
  clear_without_force(result);
  return result;
}

void ConicForces::clear_without_force(std::vector<double> &v) const
{
  for (const unsigned int row : without_force)
    v[row] = 0.;
}

std::vector<double> ConicForces::at_slacks(const std::vector<double> &x) const
{
  std::vector<double> result;
  result.reserve(n_slacks());
  for (const Bound &bound : all_bounds)
    result.push_back(bound.sign * x[bound.row]);
  for (const Cone &cone : all_cones)
    for (const std::array<double, 2> &b : cone.b)
      result.push_back(b[0] * x[cone.row] + b[1] * x[cone.row + 1]);
  return result;
}

std::vector<double> ConicForces::of_rows(const std::vector<double> &z) const
{
  std::vector<double> result(rows.n_all_rows(), 0.);
  for (std::size_t b = 0; b < all_bounds.size(); ++b)
    result[all_bounds[b].row] += all_bounds[b].sign * z[b];
  for (std::size_t k = 0; k < all_cones.size(); ++k)
  {
    const std::array<double, 2> sum = transposed(all_cones[k], of_cone(z, k));
    result[all_cones[k].row] += sum[0];
    result[all_cones[k].row + 1] += sum[1];
  }
  return result;
}

bool ConicForces::prepare(const Weights &weights,
                          const bool with_curvature,
                          const double proximal)
{
  std::vector<double> &k = coefficients;
  k.assign(rows.n_all_rows(), 0.);
  if (with_curvature)
    k = of_cost;
  for (std::size_t b = 0; b < all_bounds.size(); ++b)
    k[all_bounds[b].row] += weights.of_bounds[b];
  for (double &sum : k)
    if (sum > 0.)
      sum = 1. / (sum + proximal);
  clear_without_force(k);
  if (rows.has_blocks())
    invert_sets(weights, with_curvature);
  return factorise();
}

bool ConicForces::prepare_diagonal(std::vector<double> k)
{
  AssertDimension(all_cones.size(), 0);
  coefficients = std::move(k);
  return factorise();
}

bool ConicForces::factorise()
{
  border.clear();
  for (const double coefficient : coefficients)
    if (!std::isfinite(coefficient))
      return false;
  for (double shift = first_shift_of_forces; shift <= largest_force_shift;
       shift *= factor_of_force_shift)
    if (factor.factorise(coefficients, 0., shift))
      return true;
  return false;
}

/** Spread what rows have to the coefficients of sets, and add those of cones.
 */
void ConicForces::invert_sets(const Weights &weights, const bool with_curvature)
{
  std::vector<double> of_sets(rows.n_all_coefficients(), 0.);
  std::size_t cone = 0;
  for (unsigned int e = 0; e < rows.joints().size(); ++e)
    rows.for_each_set(e, [&](const unsigned int size, const unsigned int row,
                             const unsigned int coefficient) {
      double *const block = &of_sets[rows.first_coefficient(e) + coefficient];
      if (size == 1)
      {
        *block = coefficients[rows.first_row(e) + row];
        return;
      }
      SumOfSquares sum;
      const std::size_t r = rows.first_row(e) + row;
      if (with_curvature)
      {
        sum.add(of_cost[r], {{1., 0.}});
        sum.add(of_cost[r + 1], {{0., 1.}});
      }
      for (; cone < all_cones.size() && all_cones[cone].row == r; ++cone)
        add_cone(all_cones[cone], weights.of_cones[cone], sum);
      const std::array<double, 3> inverse = sum.inverse();
      block[0] = inverse[0];
      block[1] = block[2] = inverse[1];
      block[3] = inverse[2];
    });
  coefficients = std::move(of_sets);
}

void ConicForces::multiply(std::vector<double> &r) const
{
  rows.multiply_by_blocks(coefficients, r);
}

std::vector<double>
ConicForces::multiplied_difference(const std::vector<double> &r,
                                   const std::vector<double> &u) const
{
  std::vector<double> x = along(u);
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] = r[k] - x[k];
  multiply(x);
  for (const Cone &cone : all_cones)
  {
    const std::size_t k = cone.row;
    const unsigned int e = rows.joint_of_row(k);
    // All sets before it in its joint are of one row.
    const double *const K =
        &coefficients[rows.first_coefficient(e) + (k - rows.first_row(e))];
    const long double start = r[k] + rows.exact_jump(k, u.data()),
                      end = r[k + 1] + rows.exact_jump(k + 1, u.data());
    x[k] = static_cast<double>(K[0] * start + K[1] * end);
    x[k + 1] = static_cast<double>(K[2] * start + K[3] * end);
  }
  return x;
}

std::vector<double> ConicForces::product(const std::vector<double> &u) const
{
  std::vector<double> x = along(u);
  multiply(x);
  return on_bodies(x);
}

void ConicForces::set_border(std::vector<double> f)
{
  border = std::move(f);
  of_border = factor.solve(border, 1);
  work_of_border = dot(border, of_border);
}

/** Without a border this changes nothing. */
double ConicForces::clear_border_work(std::vector<double> &u,
                                      const double work) const
{
  if (border.empty())
    return 0.;
  const double alpha = (work - dot(border, u)) / work_of_border;
  add(u, alpha, of_border);
  return alpha;
}

ConicForces::Bordered ConicForces::solve(const std::vector<double> &right,
                                         const double work,
                                         const double enough,
                                         const unsigned int n_gradients)
{
  Bordered now = {factor.solve(right, 1), 0.};
  now.alpha = clear_border_work(now.u, work);
  std::vector<double> left = right;
  add(left, -1., product(now.u));
  if (!border.empty())
    add(left, now.alpha, border);
  Bordered best = now;
  double least = largest_component(left), previous = 0.;
  std::vector<double> direction;
  unsigned int n_in_vain = 0;
  for (unsigned int k = 0;
       k < n_gradients && least > enough && n_in_vain < n_without_gain; ++k)
  {
    // What is left is that of the best alpha, so that it does not grow.
    std::vector<double> z = factor.solve(left, 1);
    if (const double more = clear_border_work(z, 0.); more != 0.)
    {
      now.alpha += more;
      add(left, more, border);
    }
    const double product_now = dot(left, z);
    if (direction.empty())
      direction = std::move(z);
    else
      for (std::size_t i = 0; i < z.size(); ++i)
        direction[i] = z[i] + product_now / previous * direction[i];
    previous = product_now;
    const std::vector<double> force = product(direction);
    const double energy = dot(direction, force);
    if (!(energy > 0.) || !(product_now > 0.))
      break;
    add(now.u, product_now / energy, direction);
    add(left, -product_now / energy, force);
    ++n_in_vain;
    if (const double size = largest_component(left); size < least)
    {
      best = now;
      least = size;
      n_in_vain = 0;
    }
  }
  return best;
}
} // namespace Voussoir
