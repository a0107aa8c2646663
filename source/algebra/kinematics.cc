// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/kinematics.h>
#include <voussoir/base/geometry.h>

#include <deal.II/base/exceptions.h>

namespace Voussoir
{

using dealii::Tensor;

namespace
{

class Translations : public Kinematics
{
public:
  std::string name() const override { return "translations"; }
  unsigned int n_unknowns() const override { return 2; }
  unsigned int n_contacts() const override { return 1; }
  void find_rows(const JointFrame &joint, ContactRow *rows) const override
  {
    rows[0].direction = joint.normal;
    rows[1].direction = joint.tangent;
  }
  unsigned int n_rigid_motions() const override { return 2; }
  void find_rigid_motion(const unsigned int k,
                         const Tensor<1, 2> & /*x*/,
                         double *unknowns) const override
  {
    for (unsigned int i = 0; i < 2; ++i)
      unknowns[i] = i == k ? 1. : 0.;
  }
};

class Rotations : public Kinematics
{
public:
  std::string name() const override { return "rotations"; }
  unsigned int n_unknowns() const override { return 3; }
  unsigned int n_contacts() const override { return 2; }
  void find_rows(const JointFrame &joint, ContactRow *rows) const override
  {
    for (unsigned int k = 0; k < 2; ++k)
      rows[k] = {joint.normal, cross(joint.from_minus[k], joint.normal),
                 cross(joint.from_plus[k], joint.normal)};
    const auto turn = [&](const std::array<Tensor<1, 2>, 2> &ends) {
      return 0.5 * cross(ends[0] + ends[1], joint.tangent);
    };
    rows[2] = {joint.tangent, turn(joint.from_minus), turn(joint.from_plus)};
  }
  unsigned int n_rigid_motions() const override { return 3; }
  void find_rigid_motion(const unsigned int k,
                         const Tensor<1, 2> &x,
                         double *unknowns) const override
  {
    unknowns[0] = k == 0 ? 1. : k == 2 ? -x[1] : 0.;
    unknowns[1] = k == 1 ? 1. : k == 2 ? x[0] : 0.;
    unknowns[2] = k == 2 ? 1. : 0.;
  }
};

} // namespace

const Kinematics &rotations()
{
  static const Rotations kinematics;
  return kinematics;
}

const Kinematics &translations()
{
  static const Translations kinematics;
  return kinematics;
}

const Kinematics &kinematics_of(const std::string &name)
{
  for (const Kinematics *kinematics : {&translations(), &rotations()})
    if (kinematics->name() == name)
      return *kinematics;
  AssertThrow(false, dealii::ExcInternalError());
  return translations();
}

} // namespace Voussoir
