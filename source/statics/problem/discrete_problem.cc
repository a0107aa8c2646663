// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/lowest_in_sets.h>
#include <voussoir/statics/problem/discrete_problem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{

DiscreteProblem::DiscreteProblem(Data data)
    : Structure(ProcessGroup(), std::move(data.part)),
      length_unit(data.length_unit), stress_unit(data.stress_unit),
      has_load(data.is_loaded), coordinate_rounding(data.coordinate_rounding),
      n_moving_cells(data.n_cells), limits_of_joints(std::move(data.limits)),
      links_of_scene(std::move(data.links)),
      ends_that_are_open(std::move(data.open_ends))
{
  // Formulations in the plane count one coefficient a row.
  Assert(!has_blocks() || !is_plane(), dealii::ExcInternalError());
  interface_count = joints().size();
  for (const LinkContact &link : links_of_scene)
    interface_count -= link.has_joint() ? 1 : 0;
  boost::disjoint_sets_with_storage<> groups(n_bodies());
  for (const Joint &joint : joints())
    groups.union_set(joint.cell_minus, joint.cell_plus);
  group_of_body = lowest_in_sets(groups, n_bodies());
  own.n_not_judged = has_ground() ? kinematics().n_rotations() : 0;
  balance_loads();
}

/**
 * Spread what rounding leaves of the loads on a group, their work along each of
 * its rigid motions, over its cells; the ground takes that of its own group.
 */
void DiscreteProblem::balance_loads()
{
  std::vector<unsigned int> size(n_bodies(), 0);
  for (const unsigned int g : group_of_body)
    ++size[g];
  std::array<double, Kinematics::most_unknowns> motion;
  for (unsigned int k = 0; k < n_unknowns(); ++k)
  {
    // With many cells the sum of doubles would be off by more than a solver's
    // tolerance.
    std::vector<long double> sum(n_bodies(), 0.);
    for (unsigned int b = 0; b < n_bodies(); ++b)
    {
      kinematics().find_rigid_motion(k, centre(b), motion.data());
      for (unsigned int i = 0; i < n_unknowns(); ++i)
        sum[group_of_body[b]] += own.loads[dof(b, i)] * motion[i];
    }
    for (unsigned int b = 0; b < n_bodies(); ++b)
      if (!has_ground() || group_of_body[b] != group_of_body.back())
        own.loads[dof(b, k)] -= sum[group_of_body[b]] / size[group_of_body[b]];
      else if (b == n_cells())
        own.loads[dof(b, k)] = -sum[group_of_body[b]];
  }
}

void DiscreteProblem::subtract(const std::vector<RigidMotion> &motion_of_group,
                               std::vector<double> &u) const
{
  std::array<double, Kinematics::most_unknowns> unknowns;
  for (unsigned int b = 0; b < n_bodies(); ++b)
  {
    const RigidMotion &motion = motion_of_group[group_of_body[b]];
    for (unsigned int k = 0; k < n_unknowns(); ++k)
    {
      kinematics().find_rigid_motion(k, centre(b) - motion.about,
                                     unknowns.data());
      for (unsigned int i = 0; i < n_unknowns(); ++i)
        u[dof(b, i)] -= motion.size[k] * unknowns[i];
    }
  }
}

void DiscreteProblem::remove_rigid_motions(std::vector<double> &u) const
{
  std::vector<RigidMotion> motion(n_bodies());
  std::vector<unsigned int> size(n_bodies(), 0);
  for (unsigned int b = 0; b < n_bodies(); ++b)
  {
    for (unsigned int i = 0; i < n_unknowns(); ++i)
      motion[group_of_body[b]].size[i] += u[dof(b, i)];
    motion[group_of_body[b]].about += centre(b);
    ++size[group_of_body[b]];
  }
  for (unsigned int b = 0; b < n_bodies(); ++b)
    if (size[b] > 0)
    {
      motion[b].about /= size[b];
      for (double &mean : motion[b].size)
        mean /= size[b];
    }
  if (has_ground())
  {
    motion[group_of_body.back()].about = centre(n_cells());
    for (unsigned int i = 0; i < n_unknowns(); ++i)
      motion[group_of_body.back()].size[i] = u[dof(n_cells(), i)];
  }
  subtract(motion, u);
}

void DiscreteProblem::hold_bodies(std::vector<double> &u) const
{
  std::vector<RigidMotion> motion(n_bodies());
  for (unsigned int b = 0; b < n_bodies(); ++b)
    if (is_held(b))
    {
      motion[group_of_body[b]].about = centre(b);
      for (unsigned int i = 0; i < n_unknowns(); ++i)
        motion[group_of_body[b]].size[i] = u[dof(b, i)];
    }
  subtract(motion, u);
}

DiscreteProblem
DiscreteProblem::with_tresca(const std::vector<double> &limits) const
{
  if (!is_plane())
    return with_discs(limits);
  DiscreteProblem problem(*this);
  for (unsigned int e = 0; e < limits.size(); ++e)
  {
    problem.own.joints.list[e].strength = limits[e];
    problem.own.joints.list[e].coefficient = 0.;
  }
  return problem;
}

/** with_tresca() in space. */
DiscreteProblem
DiscreteProblem::with_discs(const std::vector<double> &strengths) const
{
  DiscreteProblem problem(*this);
  JointRows rows;
  rows.reserve(joints().size(), n_all_rows(), kinematics());
  unsigned int n_discs = 0;
  for (unsigned int e = 0; e < joints().size(); ++e)
  {
    Joint joint = joints()[e];
    const double part = joint.tangential_part();
    std::vector<unsigned int> sizes;
    std::vector<double> shares;
    joint.strength = 0.;
    joint.coefficient = 0.;
    for_each_face_set(e, [&](const FaceSet &set) {
      if (set.size != 2)
      {
        sizes.push_back(1);
        shares.push_back(set.share);
        rows.set_strengths.push_back(0.);
      }
      if (set.size == 1)
        return;
      sizes.push_back(2);
      shares.push_back(part * set.share);
      rows.set_strengths.push_back(strengths[n_discs]);
      joint.strength += strengths[n_discs++];
    });
    rows.add(joint, this->rows(e), kinematics(), sizes, shares);
  }
  problem.own.joints = std::move(rows);
  return problem;
}

DiscreteProblem
DiscreteProblem::with_strengths_up_to(const double strength) const
{
  DiscreteProblem problem(*this);
  for (Joint &joint : problem.own.joints.list)
    joint.strength = std::min(joint.strength, strength * joint.length);
  std::vector<double> &of_sets = problem.own.joints.set_strengths;
  for (unsigned int e = 0; e < joints().size() && !of_sets.empty(); ++e)
    for (unsigned int k = own.joints.first_set[e];
         k < own.joints.first_set[e + 1]; ++k)
      of_sets[k] = std::min(of_sets[k], strength * joints()[e].length);
  return problem;
}

std::optional<DiscreteProblem>
DiscreteProblem::without_strengths_above(const double strength) const
{
  AssertThrow(is_plane(), dealii::ExcNotImplemented());
  DiscreteProblem problem(*this);
  bool has_any = false;
  const auto remove = [&](double &limit, const Joint &joint) {
    if (!(limit > strength * joint.length) || !std::isfinite(limit))
      return;
    limit = std::numeric_limits<double>::infinity();
    has_any = true;
  };
  for (Joint &joint : problem.own.joints.list)
    remove(joint.strength, joint);
  for (unsigned int e = 0; e < problem.limits_of_joints.size(); ++e)
    remove(problem.limits_of_joints[e].crushing, joints()[e]);
  return has_any ? std::make_optional(std::move(problem)) : std::nullopt;
}

DiscreteProblem
DiscreteProblem::with_loads(const std::vector<double> &loads) const
{
  DiscreteProblem problem(*this);
  problem.own.loads = loads;
  problem.has_load = true;
  problem.balance_loads();
  return problem;
}

DiscreteProblem DiscreteProblem::in_units_of(const double factor) const
{
  DiscreteProblem problem(*this);
  problem.stress_unit *= factor;
  for (double &load : problem.own.loads)
    load /= factor;
  for (Joint &joint : problem.own.joints.list)
    joint.strength /= factor;
  for (double &strength : problem.own.joints.set_strengths)
    strength /= factor;
  for (NormalLimits &limits : problem.limits_of_joints)
    limits = {limits.tension / factor, limits.crushing / factor};
  for (LinkContact &link : problem.links_of_scene)
    link.rest /= factor;
  return problem;
}

double DiscreteProblem::largest_limit() const
{
  double largest = 0.;
  for (const Joint &joint : joints())
    largest = std::max(largest, joint.strength);
  for (const NormalLimits &limits : limits_of_joints)
  {
    largest = std::max(largest, limits.tension);
    if (std::isfinite(limits.crushing))
      largest = std::max(largest, limits.crushing);
  }
  return largest;
}

DiscreteProblem DiscreteProblem::without_loads() const
{
  DiscreteProblem problem(*this);
  problem.own.loads.assign(n_dofs(), 0.);
  return problem;
}
} // namespace Voussoir
