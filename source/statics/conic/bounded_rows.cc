// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/conic/bounded_rows.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

/** The least distance of two cuts, over that of most. */
constexpr double closest_cuts = 0.1;

/** Cuts beside a place, on each side; the others are coarse. */
constexpr int n_on_a_side = 4;
/** The reach of cuts, over that of the last time. */
constexpr double closer = 0.25;
/** Jumps of a joint, over the largest of all, that are rounding. */
constexpr double small_jump = 1e-4;

bool have_crushing(const DiscreteProblem &problem)
{
  return std::any_of(problem.normal_limits().begin(),
                     problem.normal_limits().end(),
                     [](const NormalLimits &limits) {
                       return std::isfinite(limits.crushing);
                     });
}
} // namespace

Strips::Strips(const std::size_t n_joints, const unsigned int n_strips)
    : n(n_strips), last_cut(n_joints)
{
  places.reserve(n_joints * (n + 1));
  for (std::size_t e = 0; e < n_joints; ++e)
    for (unsigned int k = 0; k <= n; ++k)
      places.push_back(double(k) / n);
}

void Strips::cut_at(const unsigned int e, const double place)
{
  Cut &last = last_cut[e];
  const double strip = 1. / n;
  const double reach =
      last.reach > 0.
          ? std::min(strip, std::max(closer * last.reach,
                                     2. * std::abs(place - last.place)))
          : strip;
  last = {place, reach};
  const double distance = reach / n_on_a_side;
  std::vector<double> cuts = {0.};
  for (int k = -n_on_a_side; k <= n_on_a_side; ++k)
    if (const double at = place + k * distance;
        at > closest_cuts * distance && at < 1. - closest_cuts * distance)
      cuts.push_back(at);
  cuts.push_back(1.);
  while (cuts.size() <= n)
  {
    unsigned int widest = 1;
    for (unsigned int k = 2; k < cuts.size(); ++k)
      if (cuts[k] - cuts[k - 1] > cuts[widest] - cuts[widest - 1])
        widest = k;
    cuts.insert(cuts.begin() + widest, 0.5 * (cuts[widest - 1] + cuts[widest]));
  }
  std::copy(cuts.begin(), cuts.end(), &places[std::size_t(e) * (n + 1)]);
}

BoundedRows::BoundedRows(const DiscreteProblem &problem, const Strips &strips)
    : Structure(problem.kinematics()), problem(problem), strips(strips)
{
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
    own.centres.push_back(problem.centre(b));
  own.joints.reserve(problem.joints().size(), problem.n_all_rows(),
                     kinematics());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const Joint &joint = problem.joints()[e];
    first.push_back(joints().size());
    if (has_cone(e) && crushes(e))
    {
      // The body between them has the centre of c-.
      own.centres.push_back(problem.centre(joint.cell_minus));
      add_rays(e, joint.cell_minus, own.centres.size() - 1);
      add_contacts_or_strips(e);
    }
    else if (has_cone(e))
      add_rays(e, joint.cell_minus, joint.cell_plus);
    else
      add_contacts_or_strips(e);
  }
  own.loads = problem.loads();
  own.loads.resize(n_unknowns() * own.centres.size(), 0.);
  Voussoir::add(own.loads, 1., offset());
}

bool BoundedRows::has_strips() const
{
  return strips.n_strips() > 1 && have_crushing(problem);
}

bool BoundedRows::crushes(const unsigned int e) const
{
  return !problem.normal_limits().empty() &&
         std::isfinite(problem.normal_limits()[e].crushing);
}

double BoundedRows::share(const unsigned int e, const unsigned int r) const
{
  if (r >= n_contacts(e))
    return 0.;
  if (!crushes(e))
    return 1. / n_contacts(e);
  const double *places = strips.of(e);
  return places[r + 1] - places[r];
}

double BoundedRows::middle(const unsigned int e, const unsigned int strip) const
{
  const double *places = strips.of(e);
  return 0.5 * (places[strip] + places[strip + 1]);
}

void BoundedRows::add(const Joint &joint,
                      const std::vector<ContactRow> &rows,
                      const double tangential)
{
  own.joints.add(joint, rows, kinematics());
  of_rows.push_back({-tangential, tangential});
}

void BoundedRows::add_rays(const unsigned int e,
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
  add(joint, rows,
      std::max(problem.limit(e) - joint.coefficient * problem.tension(e), 0.));
}

void BoundedRows::add_contacts_or_strips(const unsigned int e)
{
  Joint joint = problem.joints()[e];
  const unsigned int n = problem.n_contacts(e);
  if (!crushes(e))
  {
    of_rows.insert(of_rows.end(), n, {-infinity, 0.});
    add(joint, problem.rows(e), problem.limit(e));
    return;
  }
  std::vector<ContactRow> rows;
  const NormalLimits &limits = problem.normal_limits()[e];
  const double strength = limits.tension + limits.crushing;
  const double *places = strips.of(e);
  for (unsigned int k = 0; k < strips.n_strips(); ++k)
  {
    const double at = middle(e, k);
    rows.push_back(n == 1 ? problem.row(e, 0)
                          : combination(1. - at, problem.row(e, 0), at,
                                        problem.row(e, 1)));
    of_rows.push_back({-strength * (places[k + 1] - places[k]), 0.});
  }
  rows.push_back(problem.row(e, n));
  double tangential = problem.limit(e);
  if (has_cone(e))
  {
    joint.cell_minus = own.centres.size() - 1;
    tangential += joint.coefficient * limits.crushing;
  }
  add(joint, rows, tangential);
}

std::vector<double> BoundedRows::forces_of(const std::vector<double> &x) const
{
  std::vector<double> forces;
  forces.reserve(problem.n_all_rows());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const unsigned int n = problem.n_contacts(e);
    const double *of = &x[first_row(first[e])];
    double ends[] = {0., 0.}, tangential = of[n_contacts(first[e])];
    if (has_cone(e))
      for (unsigned int k = 0; k < n; ++k)
      {
        ends[k] = of[2 * k] + of[2 * k + 1];
        tangential +=
            problem.joints()[e].coefficient * (of[2 * k] - of[2 * k + 1]);
      }
    else if (crushes(e))
      for (unsigned int k = 0; k < strips.n_strips(); ++k)
      {
        const double at = n == 1 ? 0. : middle(e, k);
        ends[0] += (1. - at) * of[k];
        ends[1] += at * of[k];
      }
    else
      std::copy_n(of, n, ends);
    for (unsigned int k = 0; k < n; ++k)
      forces.push_back(ends[k] + problem.tension(e) / n);
    forces.push_back(tangential);
  }
  return forces;
}

void BoundedRows::add_force(const unsigned int e,
                            const unsigned int r,
                            const double factor,
                            std::vector<double> &c) const
{
  const unsigned int n = problem.n_contacts(e);
  double *of = &c[first_row(first[e])];
  const double mu = problem.joints()[e].coefficient;
  if (r == n)
  {
    of[n_contacts(first[e])] += factor;
    for (unsigned int k = 0; has_cone(e) && k < 2 * n; ++k)
      of[k] += k % 2 == 0 ? factor * mu : -factor * mu;
  }
  else if (has_cone(e))
    for (unsigned int k : {2 * r, 2 * r + 1})
      of[k] += factor;
  else if (crushes(e))
    for (unsigned int k = 0; k < strips.n_strips(); ++k)
    {
      const double at = middle(e, k);
      of[k] += factor * (n == 1 ? 1. : r == 0 ? 1. - at : at);
    }
  else
    of[r] += factor;
}

std::vector<double> BoundedRows::offset() const
{
  std::vector<double> sum(n_dofs());
  std::vector<double> tension(problem.n_all_rows(), 0.);
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    for (unsigned int k = 0; k < problem.n_contacts(e); ++k)
      tension[problem.first_row(e) + k] =
          problem.tension(e) / problem.n_contacts(e);
  problem.add_jump_gradients(-1., tension, sum);
  return sum;
}

Strips BoundedRows::cuts_for(const std::vector<double> &u) const
{
  Strips cuts = strips;
  const unsigned int last = strips.n_strips() - 1;
  if (last == 0)
    return cuts;
  double largest = 0.;
  for (const double jump : jumps(u))
    largest = std::max(largest, std::abs(jump));
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    if (!crushes(e))
      continue;
    const double first_opening = jump(with_strips(e), 0, u.data());
    const double last_opening = jump(with_strips(e), last, u.data());
    // Joints at rest are left as they are: elsewhere cut they carry less.
    if (std::abs(first_opening - last_opening) <= small_jump * largest)
      continue;
    const double from = middle(e, 0), to = middle(e, last);
    const double place =
        from + (to - from) * (first_opening / (first_opening - last_opening));
    if (place > 0. && place < 1.)
      cuts.cut_at(e, place);
  }
  return cuts;
}
} // namespace Voussoir
