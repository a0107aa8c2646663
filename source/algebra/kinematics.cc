// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/kinematics.h>

#include <algorithm>

namespace Voussoir
{

ContactRow combination(const double factor_of_a,
                       const ContactRow &a,
                       const double factor_of_b,
                       const ContactRow &b)
{
  ContactRow row;
  for (unsigned int i = 0; i < row.direction.size(); ++i)
  {
    row.direction[i] =
        factor_of_a * a.direction[i] + factor_of_b * b.direction[i];
    row.turn_minus[i] =
        factor_of_a * a.turn_minus[i] + factor_of_b * b.turn_minus[i];
    row.turn_plus[i] =
        factor_of_a * a.turn_plus[i] + factor_of_b * b.turn_plus[i];
  }
  return row;
}

void Kinematics::find_rigid_motion(const unsigned int k,
                                   const dealii::Tensor<1, 3> &x,
                                   double *unknowns) const
{
  std::fill_n(unknowns, n_unknowns(), 0.);
  unknowns[k] = 1.;
  if (k < translations)
    return;
  // The angle vector of length one, times x.
  if (translations == 2)
  {
    unknowns[0] = -x[1];
    unknowns[1] = x[0];
    return;
  }
  const unsigned int axis = k - translations;
  const unsigned int next = (axis + 1) % 3, last = (axis + 2) % 3;
  unknowns[next] = -x[last];
  unknowns[last] = x[next];
}

const Kinematics &rotations()
{
  static const Kinematics kinematics("rotations", 2, 1);
  return kinematics;
}

const Kinematics &translations()
{
  static const Kinematics kinematics("translations", 2, 0);
  return kinematics;
}

const Kinematics &rotations_in_space()
{
  static const Kinematics kinematics("rotations in space", 3, 3);
  return kinematics;
}

const Kinematics &translations_in_space()
{
  static const Kinematics kinematics("translations in space", 3, 0);
  return kinematics;
}

} // namespace Voussoir
