// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/contact/joint_quantity.h>
#include <voussoir/contact/laws/coulomb.h>

namespace Voussoir
{
void Coulomb::add_parameters(dealii::ParameterHandler &prm)
{
  using dealii::Patterns::Anything;
  prm.add_parameter("Coefficient", coefficient,
                    "The coefficient mu of Coulomb's friction, not negative; "
                    "an expression as for 'Strength'.",
                    Anything());
  prm.add_parameter("Pair coefficients", pair_coefficients,
                    "Other coefficients where two groups of cells meet, as for "
                    "'Pair strengths'.",
                    Anything());
  prm.add_parameter("Cohesion", cohesion,
                    "The cohesion c of Coulomb's friction, the shear stress at "
                    "which interfaces slide without pressure. A stress, not "
                    "negative; an expression as for 'Strength'.",
                    Anything());
  prm.add_parameter("Pair cohesions", pair_cohesions,
                    "Other cohesions where two groups of cells meet, as for "
                    "'Pair strengths'.",
                    Anything());
}

Strengths Coulomb::strengths(const Packing &packing) const
{
  Strengths result;
  result.of_interface = cohesions(packing, result.warnings);
  result.coefficient =
      means(packing,
            {"coefficient", "Friction", coefficient, "Coefficient",
             pair_coefficients, "Pair coefficients"},
            result.warnings);
  result.dilate = false;
  return result;
}

std::vector<double> Coulomb::cohesions(const Packing &packing,
                                       std::vector<std::string> &warnings) const
{
  return means(packing,
               {"cohesion", "Friction", cohesion, "Cohesion", pair_cohesions,
                "Pair cohesions"},
               warnings);
}

Strengths AssociatedCoulomb::strengths(const Packing &packing) const
{
  Strengths result = coulomb.strengths(packing);
  result.dilate = true;
  return result;
}
} // namespace Voussoir
