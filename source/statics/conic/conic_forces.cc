// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/conic/conic_forces.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/** The cone N^2 <= 2 f |e| p_k of one end of a section. */
ConicForces::Cone cone_of(const ForceRows::Section &section,
                          const unsigned int end)
{
  // (a + g p)^2 - (a - g p)^2 = 4 a g p = 2 f |e| p, where p is minus the
  // force, and of order one: g lets the two have the same size.
  const double g = std::max(1., std::sqrt(0.5 * section.strength));
  const double a = 0.5 * section.strength / g;
  ConicForces::Cone cone = {section.row, 2, {{a, -a, 0.}}, {}};
  cone.b[0][end] = cone.b[1][end] = g;
  cone.b[2] = {{1., 1., 0.}};
  return cone;
}

/** The cone of two rows in a circle, of an arc or a disc. */
template <typename Circle>
ConicForces::Cone cone_of_circle(const Circle &circle)
{
  return {circle.row,
          2,
          {{circle.strength, 0., 0.}},
          {{{{0., 0., 0.}}, {{-1., 0., 0.}}, {{0., -1., 0.}}}}};
}

/** The cone of a pressure and its friction. */
ConicForces::Cone cone_of(const ForceRows::FrictionCone &cone)
{
  return {cone.row,
          3,
          {{0., 0., 0.}},
          {{{{cone.coefficient, 0., 0.}}, {{0., -1., 0.}}, {{0., 0., -1.}}}}};
}
} // namespace

ConicForces::ConicForces(const ForceRows &rows,
                         std::vector<bool> held,
                         std::vector<double> curvature)
    : rows(rows), held(std::move(held)), of_cost(std::move(curvature)),
      joints_of_bodies(rows),
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
    all_cones.push_back(cone_of_circle(arc));
  for (const ForceRows::Disc &disc : rows.discs())
    all_cones.push_back(cone_of_circle(disc));
  for (const ForceRows::FrictionCone &cone : rows.friction_cones())
  {
    all_cones.push_back(cone_of(cone));
    if (std::isfinite(cone.strength))
    {
      all_cones.back().bound = all_bounds.size();
      all_bounds.push_back({cone.row, -1., cone.strength});
    }
  }
  // In the order of the rows, as sets are gone through.
  std::stable_sort(all_cones.begin(), all_cones.end(),
                   [](const Cone &a, const Cone &b) { return a.row < b.row; });
  find_coefficients();
  find_rows_without_limits();
}

/** Those that are in no bound and no cone; in space each is in one. */
void ConicForces::find_rows_without_limits()
{
  if (!rows.is_plane())
    return;
  std::vector<bool> is_limited(rows.n_all_rows(), false);
  for (const Bound &bound : all_bounds)
    is_limited[bound.row] = true;
  for (const Cone &cone : all_cones)
    std::fill_n(is_limited.begin() + cone.row, cone.n_rows, true);
  for (const unsigned int row : without_force)
    is_limited[row] = true;
  for (unsigned int r = 0; r < is_limited.size(); ++r)
    if (!is_limited[r])
      rows_without_limits.push_back(r);
}

/** Cone::coefficient of all cones. */
void ConicForces::find_coefficients()
{
  auto cone = all_cones.begin();
  for (unsigned int e = 0; e < rows.joints().size(); ++e)
    rows.for_each_set(e, [&](unsigned int, const unsigned int row,
                             const unsigned int coefficient) {
      for (; cone != all_cones.end() && cone->row == rows.first_row(e) + row;
           ++cone)
        cone->coefficient = rows.first_coefficient(e) + coefficient;
    });
}

void ConicForces::clear_held(std::vector<double> &loads) const
{
  for (unsigned int b = 0; b < held.size(); ++b)
    if (held[b])
      for (unsigned int i = 0; i < rows.n_unknowns(); ++i)
        loads[rows.dof(b, i)] = 0.;
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
  std::vector<double> sum = joints_of_bodies.forces_on_bodies(-1., x);
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
  std::vector<double> result(n_slacks());
  for (std::size_t b = 0; b < all_bounds.size(); ++b)
    result[b] = all_bounds[b].sign * x[all_bounds[b].row];
  for_each_cone([&](const std::size_t k) {
    const Cone &cone = all_cones[k];
    const double *const of = &x[cone.row];
    QuadraticCone::Vector slacks;
    for (unsigned int i = 0; i < 3; ++i)
    {
      slacks[i] = cone.b[i][0] * of[0] + cone.b[i][1] * of[1];
      if (cone.n_rows == 3)
        slacks[i] += cone.b[i][2] * of[2];
    }
    set_cone(result, k, slacks);
  });
  return result;
}
} // namespace Voussoir
