// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/kinematics.h>

#include <deal.II/base/exceptions.h>

namespace Voussoir
{
namespace
{

class Translations : public Kinematics
{
public:
  std::string name() const override
  {
    return "translations";
  }
  unsigned int n_unknowns() const override
  {
    return 2;
  }
  unsigned int n_contacts() const override
  {
    return 1;
  }
  void find_rows(const JointFrame &joint, ContactRow *rows) const override
  {
    rows[0].direction = joint.normal;
    rows[1].direction = joint.tangent;
  }
  unsigned int n_rigid_motions() const override
  {
    return 2;
  }
  void find_rigid_motion(const unsigned int k,
                         const dealii::Tensor<1, 2> & /*x*/,
                         double *unknowns) const override
  {
    for (unsigned int i = 0; i < 2; ++i)
      unknowns[i] = i == k ? 1. : 0.;
  }
};

} // namespace

const Kinematics &translations()
{
  static const Translations kinematics;
  return kinematics;
}

const Kinematics &kinematics_of(const std::string &name)
{
  for (const Kinematics *kinematics : {&translations()})
    if (kinematics->name() == name)
      return *kinematics;
  AssertThrow(false, dealii::ExcInternalError());
  return translations();
}

} // namespace Voussoir
