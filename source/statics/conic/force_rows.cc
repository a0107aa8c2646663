// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/conic/force_rows.h>
#include <voussoir/statics/problem/mechanism.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

/** The contacts of a section. */
constexpr unsigned int n_ends = 2;
/** The rows of an arc. */
constexpr unsigned int n_of_arc = 2;
} // namespace

ForceRows::ForceRows(const DiscreteProblem &problem, const Friction friction)
    : Structure(problem.kinematics()), problem(problem)
{
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
    own.centres.push_back(problem.centre(b));
  own.joints.reserve(problem.joints().size(), problem.n_all_rows(),
                     kinematics());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const Joint &joint = problem.joints()[e];
    first.push_back(joints().size());
    if (!problem.is_plane())
      add_sets(e);
    else if (has_cone(e) && crushes(e))
    {
      // The body between them has the centre of c-.
      own.centres.push_back(problem.centre(joint.cell_minus));
      add_rays(e, joint.cell_minus, own.centres.size() - 1);
      add_contacts(e, friction);
    }
    else if (has_cone(e))
      add_rays(e, joint.cell_minus, joint.cell_plus);
    else
      add_contacts(e, friction);
  }
  own.loads = problem.loads();
  own.loads.resize(n_unknowns() * own.centres.size(), 0.);
  Voussoir::add(own.loads, 1., offset());
}

bool ForceRows::crushes(const unsigned int e) const
{
  return !problem.normal_limits().empty() &&
         std::isfinite(problem.normal_limits()[e].crushing);
}

void ForceRows::add_rays(const unsigned int e,
                         const unsigned int minus,
                         const unsigned int plus)
{
  Joint joint = problem.joints()[e];
  const bool is_whole = plus == joint.cell_plus;
  joint.cell_minus = minus;
  joint.cell_plus = plus;
  std::vector<ContactRow> rows;
  const unsigned int n = problem.n_contacts(e);
  for (unsigned int r = 0; r < n; ++r)
    for (const double slope : {joint.coefficient, -joint.coefficient})
    {
      rows.push_back(
          combination(1., problem.row(e, r), slope, problem.row(e, n)));
      of_rows.push_back({-infinity, 0.});
    }
  rows.push_back(problem.row(e, n));
  if (!is_whole)
    for (ContactRow &row : rows)
      row.turn_plus = row.turn_minus;
  const double tangential =
      std::max(problem.limit(e) - joint.coefficient * problem.tension(e), 0.);
  of_rows.push_back({-tangential, tangential});
  own.joints.add(joint, rows, kinematics());
}

void ForceRows::add_contacts(const unsigned int e, const Friction friction)
{
  Joint joint = problem.joints()[e];
  const unsigned int n = problem.n_contacts(e);
  double tangential = problem.limit(e);
  std::vector<unsigned int> sets;
  if (!crushes(e))
    of_rows.insert(of_rows.end(), n, {-infinity, 0.});
  else
  {
    const NormalLimits &limits = problem.normal_limits()[e];
    const double strength = limits.tension + limits.crushing;
    if (n == n_ends)
    {
      all_sections.push_back(
          {static_cast<unsigned int>(of_rows.size()), strength});
      of_rows.insert(of_rows.end(), n, {-infinity, infinity});
      sets = {n_ends, 1};
    }
    else
      of_rows.insert(of_rows.end(), n, {-strength, 0.});
    if (has_cone(e))
    {
      joint.cell_minus = own.centres.size() - 1;
      tangential += joint.coefficient * limits.crushing;
    }
  }
  std::vector<ContactRow> rows = problem.rows(e);
  if (friction == Friction::in_arcs && tangential > 0.)
  {
    if (sets.empty())
      sets.assign(n, 1);
    else
      sets.pop_back();
    sets.push_back(n_of_arc);
    all_arcs.push_back({static_cast<unsigned int>(of_rows.size()), tangential});
    of_rows.insert(of_rows.end(), n_of_arc, {-infinity, infinity});
    rows.push_back({});
  }
  else
    of_rows.push_back({-tangential, tangential});
  own.joints.add(joint, rows, kinematics(), sets);
}

/** Of a joint in space. */
void ForceRows::add_sets(const unsigned int e)
{
  const Joint &joint = problem.joints()[e];
  const double strength =
      problem.normal_limits().empty()
          ? infinity
          : problem.tension(e) + problem.normal_limits()[e].crushing;
  problem.for_each_face_set(e, [&](const FaceSet &set) {
    const unsigned int row = of_rows.size();
    if (set.size == 1)
      of_rows.push_back({-strength * set.share, 0.});
    else if (set.size == 2 && !(set.strength > 0.))
      of_rows.insert(of_rows.end(), set.size, {0., 0.});
    else
      of_rows.insert(of_rows.end(), set.size, {-infinity, infinity});
    if (set.size == 2 && set.strength > 0.)
      all_discs.push_back({row, set.strength});
    else if (set.size == 3)
      all_cones.push_back({row, joint.coefficient, strength * set.share});
  });
  own.joints.add(joint, problem.rows(e), kinematics(), problem.sets(e));
}

std::vector<double> ForceRows::forces_of(const std::vector<double> &x) const
{
  if (!problem.is_plane())
  {
    std::vector<double> forces = tension();
    Voussoir::add(forces, 1., x);
    return forces;
  }
  std::vector<double> forces;
  forces.reserve(problem.n_all_rows());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const unsigned int n = problem.n_contacts(e);
    const double *of = &x[first_row(first[e])];
    double ends[] = {0., 0.}, tangential = of[has_cone(e) ? 2 * n : n];
    if (has_cone(e))
      for (unsigned int k = 0; k < n; ++k)
      {
        ends[k] = of[2 * k] + of[2 * k + 1];
        tangential +=
            problem.joints()[e].coefficient * (of[2 * k] - of[2 * k + 1]);
      }
    else
      std::copy_n(of, n, ends);
    for (unsigned int k = 0; k < n; ++k)
      forces.push_back(ends[k] + problem.tension(e) / n);
    forces.push_back(tangential);
  }
  return forces;
}

std::vector<double> ForceRows::rows_of(const std::vector<double> &forces) const
{
  AssertThrow(!problem.is_plane(), dealii::ExcNotImplemented());
  std::vector<double> x = forces;
  Voussoir::add(x, -1., tension());
  return x;
}

void ForceRows::add_force(const unsigned int e,
                          const unsigned int r,
                          const double factor,
                          std::vector<double> &c) const
{
  if (!problem.is_plane())
  {
    c[first_row(e) + r] += factor;
    return;
  }
  const unsigned int n = problem.n_contacts(e);
  double *of = &c[first_row(first[e])];
  const double mu = problem.joints()[e].coefficient;
  if (r == n)
  {
    of[has_cone(e) ? 2 * n : n] += factor;
    for (unsigned int k = 0; has_cone(e) && k < 2 * n; ++k)
      of[k] += k % 2 == 0 ? factor * mu : -factor * mu;
  }
  else if (has_cone(e))
    for (unsigned int k : {2 * r, 2 * r + 1})
      of[k] += factor;
  else
    of[r] += factor;
}

/** The forces of the problem that are the origin of x, of each row. */
std::vector<double> ForceRows::tension() const
{
  std::vector<double> forces(problem.n_all_rows(), 0.);
  if (problem.normal_limits().empty())
    return forces;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    double *const of = &forces[problem.first_row(e)];
    problem.for_each_pressure(e,
                              [&](const unsigned int row, const double share) {
                                of[row] = problem.tension(e) * share;
                              });
  }
  return forces;
}

std::vector<double> ForceRows::offset() const
{
  std::vector<double> sum(n_dofs());
  problem.add_jump_gradients(-1., tension(), sum);
  return sum;
}

double ForceRows::dissipation_of_jumps(const std::vector<double> &jump) const
{
  double sum = 0.;
  for (std::size_t k = 0; k < jump.size(); ++k)
  {
    const double most = jump[k] > 0. ? of_rows[k].greatest : of_rows[k].least;
    if (std::isfinite(most))
      sum += most * jump[k];
  }
  for (const Section &section : all_sections)
    sum += section.strength *
           negative_part(jump[section.row], jump[section.row + 1]);
  for (const Disc &disc : all_discs)
    sum += disc.strength * std::hypot(jump[disc.row], jump[disc.row + 1]);
  for (const FrictionCone &cone : all_cones)
    if (std::isfinite(cone.strength))
      sum += cone.strength *
             std::max(cone.coefficient * std::hypot(jump[cone.row + 1],
                                                    jump[cone.row + 2]) -
                          jump[cone.row],
                      0.);
  return sum;
}
} // namespace Voussoir
