// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/contact/laws/coulomb.h>

namespace Voussoir
{
void Coulomb::add_parameters(dealii::ParameterHandler &prm)
{
  coefficient.add_parameters(
      prm,
      "The coefficient mu of Coulomb's friction, not negative; "
      "an expression as for 'Strength'.",
      "Other coefficients where two groups of cells meet, as for "
      "'Pair strengths'.");
  cohesion.add_parameters(
      prm,
      "The cohesion c of Coulomb's friction, the shear stress at "
      "which interfaces slide without pressure. A stress, not "
      "negative; an expression as for 'Strength'.",
      "Other cohesions where two groups of cells meet, as for "
      "'Pair strengths'.");
}

Strengths Coulomb::strengths(const JointMeans &means) const
{
  Strengths result;
  result.of_interface = cohesions(means, result.warnings);
  result.coefficient = means(coefficient, result.warnings);
  result.dilate = false;
  return result;
}

Strengths AssociatedCoulomb::strengths(const JointMeans &means) const
{
  Strengths result = coulomb.strengths(means);
  result.dilate = true;
  return result;
}
} // namespace Voussoir
