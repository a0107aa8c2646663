// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/extreme_rays.h>

#include <algorithm>
#include <array>

namespace Voussoir
{
namespace
{
/** The motions of another kinematics, whose contacts have two rows each. */
class TwoRowsEach : public Kinematics
{
public:
  explicit TwoRowsEach(const Kinematics &of) : of(of) {}
  std::string name() const override { return of.name() + " by rays"; }
  unsigned int n_unknowns() const override { return of.n_unknowns(); }
  unsigned int n_contacts() const override { return 2 * of.n_contacts(); }
  void find_rows(const JointFrame & /*joint*/,
                 ContactRow * /*rows*/) const override
  {
    // The rows depend on the coefficient of friction: see ExtremeRays.
    AssertThrow(false, dealii::ExcInternalError());
  }
  unsigned int n_rigid_motions() const override { return of.n_rigid_motions(); }
  void find_rigid_motion(const unsigned int k,
                         const dealii::Tensor<1, 2> &x,
                         double *unknowns) const override
  {
    of.find_rigid_motion(k, x, unknowns);
  }

private:
  const Kinematics &of;
};

bool have_friction_with_pressure(const Structure &joints)
{
  return std::any_of(
      joints.joints().begin(), joints.joints().end(),
      [](const Structure::Joint &joint) { return joint.coefficient > 0.; });
}

const Kinematics &kinematics_of_rays(const Structure &joints)
{
  static const TwoRowsEach by_two(translations()), by_three(rotations());
  if (!have_friction_with_pressure(joints))
    return joints.kinematics();
  return joints.n_unknowns() == 2 ? by_two : by_three;
}

/** n + factor t. */
ContactRow sum(const ContactRow &n, const double factor, const ContactRow &t)
{
  return {n.direction + factor * t.direction,
          n.turn_minus + factor * t.turn_minus,
          n.turn_plus + factor * t.turn_plus};
}
} // namespace

ExtremeRays::ExtremeRays(const Structure &joints)
    : Structure(kinematics_of_rays(joints), joints.friction()),
      n_points(joints.n_contacts())
{
  own.loads.assign(joints.n_dofs(), 0.);
  own.centres = joints.centres();
  own.joints.list.reserve(joints.joints().size());
  own.joints.direction.reserve(joints.joints().size() * n_rows());
  std::array<ContactRow, most_rows> rows;
  for (unsigned int e = 0; e < joints.joints().size(); ++e)
  {
    const Joint &joint = joints.joints()[e];
    const ContactRow t = joints.row(e, n_points);
    for (unsigned int r = 0; r < n_contacts(); ++r)
    {
      const ContactRow n = joints.row(e, n_contacts() > n_points ? r / 2 : r);
      rows[r] =
          n_contacts() > n_points
              ? sum(n, r % 2 == 0 ? joint.coefficient : -joint.coefficient, t)
              : n;
    }
    rows[n_contacts()] = t;
    own.joints.add(joint, rows.data(), n_rows(), n_unknowns() > 2);
  }
}

std::vector<double>
ExtremeRays::forces_of(const std::vector<double> &rays) const
{
  if (n_contacts() == n_points)
    return rays;
  std::vector<double> forces;
  forces.reserve(joints().size() * (n_points + 1));
  auto ray = rays.begin();
  for (const Joint &joint : joints())
  {
    double tangential = 0.;
    for (unsigned int k = 0; k < n_points; ++k, ray += 2)
    {
      forces.push_back(ray[0] + ray[1]);
      tangential += joint.coefficient * (ray[0] - ray[1]);
    }
    forces.push_back(tangential + *ray++);
  }
  return forces;
}
} // namespace Voussoir
