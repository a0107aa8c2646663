// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/lowest_in_sets.h>
#include <voussoir/contact/contact_points.h>
#include <voussoir/statics/problem/discrete_problem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
Tensor<1, 3> in_space(const Tensor<1, 2> &x)
{
  Tensor<1, 3> result;
  std::copy_n(x.begin_raw(), 2, result.begin_raw());
  return result;
}

/** A joint as its two bodies see it; nondimensional. */
struct JointFrame
{
  /** n_e, from c- to c+, and t_e. */
  Tensor<1, 2> normal, tangent;
  /** The ends of the joint, start and end along t_e, from the centre of a body.
   */
  std::array<Tensor<1, 2>, 2> from_minus, from_plus;

  /** The row of a point, in the direction @p d. */
  ContactRow row(const ContactPoint &point, const Tensor<1, 2> &d) const
  {
    const auto turn = [&](const std::array<Tensor<1, 2>, 2> &ends) {
      return cross((1. - point.place) * ends[0] + point.place * ends[1], d);
    };
    return {{{d[0], d[1], 0.}}, {{turn(from_minus)}}, {{turn(from_plus)}}};
  }

  /** The same joint with the other body as c-. */
  void exchange_bodies()
  {
    normal *= -1.;
    tangent *= -1.;
    std::swap(from_minus, from_plus);
    std::swap(from_minus[0], from_minus[1]);
    std::swap(from_plus[0], from_plus[1]);
  }
};
} // namespace

DiscreteProblem::DiscreteProblem(const Scene &scene)
    : DiscreteProblem(scene, std::vector<bool>(scene.packing.n_cells(), true))
{}

DiscreteProblem::DiscreteProblem(const Scene &scene,
                                 const std::vector<bool> &moves)
    : Structure(*scene.kinematics)
{
  choose_scales(scene, moves);
  const Packing &packing = scene.packing;
  const double area = packing.area();
  dealii::Point<2> centroid;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    centroid += packing.area(c) / area * packing.centre(c);
  own.centres.reserve(packing.n_cells() + 1);
  own.loads.reserve(n_unknowns() * (packing.n_cells() + 1));
  std::vector<unsigned int> body(packing.n_cells() + 1);
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (moves[c])
    {
      body[c] = n_moving_cells++;
      const Tensor<1, 2> x = (packing.centre(c) - centroid) / length_unit;
      own.centres.push_back(in_space(x));
      own.loads.resize(n_unknowns() * n_moving_cells);
      find_load(scene, c, &own.loads[dof(body[c], 0)]);
    }
  for (unsigned int c = 0; c <= packing.n_cells(); ++c)
    if (c == packing.ground() || !moves[c])
      body[c] = n_cells();
  const std::size_t n_interfaces = packing.interfaces().size();
  own.joints.reserve(n_interfaces,
                     n_interfaces *
                         (contact_points(scene.turns()).pressure.size() + 1),
                     kinematics());
  bool rests_on_ground = false;
  for (unsigned int e = 0; e < n_interfaces; ++e)
  {
    add_interface(scene, e, body, centroid);
    rests_on_ground |=
        !joints().empty() && joints().back().cell_plus == n_cells();
  }
  if (rests_on_ground)
  {
    own.centres.emplace_back();
    own.loads.resize(own.loads.size() + n_unknowns());
  }
  boost::disjoint_sets_with_storage<> groups(n_bodies());
  for (const Joint &joint : joints())
    groups.union_set(joint.cell_minus, joint.cell_plus);
  group = lowest_in_sets(groups, n_bodies());
  balance_loads();
}

/** Find the load on a cell, n_unknowns() numbers. */
void DiscreteProblem::find_load(const Scene &scene,
                                const unsigned int cell,
                                double *load) const
{
  const Tensor<1, 2> force = scene.load[cell] / (stress_unit * length_unit);
  std::copy_n(force.begin_raw(), 2, load);
  if (scene.turns())
    load[2] =
        scene.load_torque[cell] / (stress_unit * length_unit * length_unit);
}

/** Joints with the ground have it as c+; those within it are none. */
void DiscreteProblem::add_interface(const Scene &scene,
                                    const unsigned int interface,
                                    const std::vector<unsigned int> &body,
                                    const dealii::Point<2> &centroid)
{
  const Packing::Interface &i = scene.packing.interfaces()[interface];
  unsigned int minus = body[i.cell_minus], plus = body[i.cell_plus];
  if (minus == n_cells() && plus == n_cells())
    return;
  JointFrame frame = {i.normal, i.tangent(), {}, {}};
  const std::array<dealii::Point<2>, 2> ends = {{i.start, i.end}};
  const auto from = [&](const unsigned int cell, const unsigned int b,
                        const unsigned int k) {
    return b == n_cells()
               ? (ends[k] - centroid) / length_unit
               : (ends[k] - scene.packing.centre(cell)) / length_unit;
  };
  for (unsigned int k = 0; k < 2; ++k)
  {
    frame.from_minus[k] = from(i.cell_minus, minus, k);
    frame.from_plus[k] = from(i.cell_plus, plus, k);
  }
  if (minus == n_cells())
  {
    std::swap(minus, plus);
    frame.exchange_bodies();
  }
  const ContactPoints &points = contact_points(scene.turns());
  std::vector<ContactRow> rows;
  for (const ContactPoint &point : points.pressure)
    rows.push_back(frame.row(point, frame.normal));
  rows.push_back(frame.row(points.friction, frame.tangent));
  const double length = i.length / length_unit;
  own.joints.add(
      {minus, plus, length, scene.packing.distance(i) / length_unit,
       scene.strength[interface] / stress_unit * length,
       scene.coefficient.empty() ? 0. : scene.coefficient[interface]},
      rows, kinematics());
  if (!scene.has_normal_limits())
    return;
  const JointLimits limits = scene.limits(interface);
  const double force_unit = stress_unit * length_unit;
  limits_of_joints.push_back(
      {limits.tension / force_unit, limits.crushing / force_unit});
}

void DiscreteProblem::choose_scales(const Scene &scene,
                                    const std::vector<bool> &moves)
{
  const double area = scene.packing.area();
  length_unit = std::sqrt(area / scene.packing.n_cells());
  double largest = 0.;
  for (const Packing::Interface &i : scene.packing.interfaces())
    for (const dealii::Point<2> &x : {i.start, i.end})
      largest = std::max({largest, std::abs(x[0]), std::abs(x[1])});
  coordinate_rounding =
      std::numeric_limits<double>::epsilon() * largest / length_unit;

  // All forces on the packing over its size: of the order of the boundary
  // traction, or of the pressure at the foot of a wall under its own weight.
  double total = 0.;
  for (unsigned int c = 0; c < moves.size(); ++c)
    if (moves[c])
      total += scene.load[c].norm() +
               (scene.load_torque.empty()
                    ? 0.
                    : std::abs(scene.load_torque[c]) / length_unit);
  has_load = total > 0.;
  if (has_load)
    stress_unit = total / std::sqrt(area);
}

/**
 * Spread what rounding leaves of the loads on a group, their work along each of
 * its rigid motions, over its cells; the ground takes that of its own group.
 */
void DiscreteProblem::balance_loads()
{
  std::vector<unsigned int> size(n_bodies(), 0);
  for (const unsigned int g : group)
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
        sum[group[b]] += own.loads[dof(b, i)] * motion[i];
    }
    for (unsigned int b = 0; b < n_bodies(); ++b)
      if (!has_ground() || group[b] != group.back())
        own.loads[dof(b, k)] -= sum[group[b]] / size[group[b]];
      else if (b == n_cells())
        own.loads[dof(b, k)] = -sum[group[b]];
  }
}

void DiscreteProblem::subtract(const std::vector<RigidMotion> &motion_of_group,
                               std::vector<double> &u) const
{
  std::array<double, Kinematics::most_unknowns> unknowns;
  for (unsigned int b = 0; b < n_bodies(); ++b)
  {
    const RigidMotion &motion = motion_of_group[group[b]];
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
      motion[group[b]].size[i] += u[dof(b, i)];
    motion[group[b]].about += centre(b);
    ++size[group[b]];
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
    motion[group.back()].about = centre(n_cells());
    for (unsigned int i = 0; i < n_unknowns(); ++i)
      motion[group.back()].size[i] = u[dof(n_cells(), i)];
  }
  subtract(motion, u);
}

void DiscreteProblem::hold_bodies(std::vector<double> &u) const
{
  std::vector<RigidMotion> motion(n_bodies());
  for (unsigned int b = 0; b < n_bodies(); ++b)
    if (is_held(b))
    {
      motion[group[b]].about = centre(b);
      for (unsigned int i = 0; i < n_unknowns(); ++i)
        motion[group[b]].size[i] = u[dof(b, i)];
    }
  subtract(motion, u);
}

Motion DiscreteProblem::motion_of_cells(const std::vector<double> &u,
                                        const double unit) const
{
  Motion motion(n_cells(), kinematics());
  for (unsigned int c = 0; c < n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      motion.displacement[c][i] = unit * u[dof(c, i)];
  for (unsigned int c = 0; c < motion.rotation.size(); ++c)
    motion.rotation[c] = unit * u[dof(c, 2)] / length_unit;
  return motion;
}

std::vector<double> DiscreteProblem::unknowns_of(const Motion &motion,
                                                 const double unit) const
{
  std::vector<double> u(n_dofs(), 0.);
  for (unsigned int c = 0; c < n_cells(); ++c)
    for (unsigned int i = 0; i < 2; ++i)
      u[dof(c, i)] = motion.displacement[c][i] / unit;
  for (unsigned int c = 0; c < motion.rotation.size(); ++c)
    u[dof(c, 2)] = motion.rotation[c] * length_unit / unit;
  return u;
}

DiscreteProblem
DiscreteProblem::with_tresca(const std::vector<double> &limits) const
{
  DiscreteProblem problem(*this);
  for (unsigned int e = 0; e < limits.size(); ++e)
  {
    problem.own.joints.list[e].strength = limits[e];
    problem.own.joints.list[e].coefficient = 0.;
  }
  return problem;
}

DiscreteProblem
DiscreteProblem::with_strengths_up_to(const double strength) const
{
  DiscreteProblem problem(*this);
  for (Joint &joint : problem.own.joints.list)
    joint.strength = std::min(joint.strength, strength * joint.length);
  return problem;
}

std::vector<double> DiscreteProblem::loads_of(const Scene &scene) const
{
  std::vector<double> loads(n_dofs());
  for (unsigned int c = 0; c < n_cells(); ++c)
    find_load(scene, c, &loads[dof(c, 0)]);
  return loads;
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
  for (NormalLimits &limits : problem.limits_of_joints)
    limits = {limits.tension / factor, limits.crushing / factor};
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
