// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/contact/friction.h>
#include <voussoir/contact/joint_quantity.h>

namespace Voussoir
{
void FrictionParameters::add_parameters(dealii::ParameterHandler &prm)
{
  using dealii::Patterns::Anything;
  prm.enter_subsection("Friction");
  add_choice<Law>(
      prm, "Law", law,
      {{Law::tresca, "Tresca", "|f_t| <= s_T |e|, whatever the pressure.",
        "Strength, Pair strengths"},
       {Law::coulomb, "Coulomb",
        "|f_t| <= c |e| + mu p with the compressive force p. Blocks slide "
        "along their joints; what carries is then not certain from forces "
        "alone, and what collapses is, if it is so with the next law.",
        "Coefficient, Pair coefficients, Cohesion, Pair cohesions"},
       {Law::associated_coulomb, "associated Coulomb",
        "the same, where joints that slide open by mu times the sliding, so "
        "that the theorems of limit analysis hold.",
        "Coefficient, Pair coefficients, Cohesion, Pair cohesions"}},
      "The largest tangential force f_t on an interface of the length |e|.");
  prm.add_parameter("Strength", strength,
                    "The Tresca strength s_T of the interfaces: the shear "
                    "stress at which they slide, whatever the normal stress. "
                    "A stress, not negative; an expression in x, y and the "
                    "unit normal nx, ny of the interface, whose sign is "
                    "arbitrary: abs(ny) > 0.5 ? 1 : 0.2 is one strength for "
                    "bed joints and another for head joints.");
  prm.add_parameter("Pair strengths", pair_strengths,
                    "Other strengths where two groups of cells meet, \"name, "
                    "name: expression | name, name: expression\", as in "
                    "brick, lintel: 0.3 | brick, ground: 1 + x; one name alone "
                    "stands for the joints within its group. What supports the "
                    "packing is called ground.",
                    Anything());
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
  prm.leave_subsection();
}

Strengths FrictionParameters::strengths(const Packing &packing) const
{
  Strengths result;
  if (law == Law::tresca)
    result.of_interface = means(packing,
                                {"strength", "Friction", strength, "Strength",
                                 pair_strengths, "Pair strengths"},
                                result.warnings);
  else
  {
    result.of_interface = means(packing,
                                {"cohesion", "Friction", cohesion, "Cohesion",
                                 pair_cohesions, "Pair cohesions"},
                                result.warnings);
    result.coefficient =
        means(packing,
              {"coefficient", "Friction", coefficient, "Coefficient",
               pair_coefficients, "Pair coefficients"},
              result.warnings);
  }
  result.dilate = law != Law::coulomb;
  return result;
}
} // namespace Voussoir
