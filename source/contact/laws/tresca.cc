// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/contact/laws/tresca.h>

namespace Voussoir
{
void Tresca::add_parameters(dealii::ParameterHandler &prm)
{
  strength.add_parameters(
      prm,
      "The Tresca strength s_T of the interfaces: the shear "
      "stress at which they slide, whatever the normal stress. "
      "A stress, not negative; an expression in x, y and the "
      "unit normal nx, ny of the interface, in space in z and nz too, whose "
      "sign is arbitrary: abs(ny) > 0.5 ? 1 : 0.2 is one strength for "
      "bed joints and another for head joints. Or a number for each "
      "interface, in their order, as in list 1, 0.2, 1.",
      "Other strengths where two groups of cells meet, \"name, "
      "name: expression | name, name: expression\", as in "
      "brick, lintel: 0.3 | brick, ground: 1 + x; one name alone "
      "stands for the joints within its group. What supports the "
      "packing is called ground.");
}

Strengths Tresca::strengths(const JointMeans &means) const
{
  Strengths result;
  result.of_interface = means(strength, result.warnings);
  return result;
}
} // namespace Voussoir
