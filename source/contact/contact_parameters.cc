// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/contact/contact_parameters.h>
#include <voussoir/contact/joint_quantity.h>

#include <algorithm>
#include <limits>

namespace Voussoir
{
namespace
{
/** Refuse tension at which Coulomb's friction admits no forces at all. */
void check_tension(const Packing &packing, const Strengths &strengths)
{
  for (unsigned int e = 0; e < strengths.coefficient.size(); ++e)
  {
    const Packing::Interface &i = packing.interfaces()[e];
    const double cohesion = strengths.of_interface[e];
    const double least = strengths.coefficient[e] * strengths.tensile[e];
    if (least > cohesion)
      throw InputError(text(
          "The tensile strength of the interface of ",
          packing.describe(i.cell_minus), " and ",
          packing.describe(i.cell_plus), " at ", text_of_point(i.midpoint()),
          " is ", strengths.tensile[e], ", but with the coefficient ",
          strengths.coefficient[e], " and the cohesion ", cohesion,
          " friction admits no more tension than ",
          cohesion / strengths.coefficient[e],
          ". Lower 'Contact/Tensile strength', or give a 'Friction/"
          "Cohesion' of at least ",
          least, "."));
  }
}
} // namespace

void ContactParameters::add_parameters(dealii::ParameterHandler &prm)
{
  using dealii::Patterns::Anything;
  prm.enter_subsection("Contact");
  prm.add_parameter("Tensile strength", tensile,
                    "The tensile strength f_t of the interfaces, the tensile "
                    "stress at which they open. Not negative; an expression in "
                    "x, y and the unit normal nx, ny as for "
                    "'Friction/Strength'. With Coulomb's friction at most "
                    "'Cohesion' over 'Coefficient'.",
                    Anything());
  prm.add_parameter("Pair tensile strengths", pair_tensile,
                    "Other tensile strengths where two groups of cells meet, "
                    "as for 'Friction/Pair strengths'.",
                    Anything());
  prm.add_parameter("Compressive strength", compressive,
                    "The compressive strength f_c of the interfaces, the "
                    "compressive stress at which they crush: no normal force "
                    "is larger than f_c |e|, and where blocks turn than "
                    "f_c (|e| - 2 |e_N|) with the eccentricity e_N. Positive; "
                    "an expression as above. Empty: interfaces do not crush.",
                    Anything());
  prm.add_parameter("Pair compressive strengths", pair_compressive,
                    "Other compressive strengths where two groups of cells "
                    "meet, as above.",
                    Anything());
  prm.leave_subsection();
}

void ContactParameters::add_strengths(const Packing &packing,
                                      Strengths &strengths) const
{
  strengths.tensile =
      means(packing,
            {"tensile strength", "Contact", tensile, "Tensile strength",
             pair_tensile, "Pair tensile strengths"},
            strengths.warnings);
  check_tension(packing, strengths);
  const auto are_all = [](const auto &of, const double value) {
    return std::all_of(of.begin(), of.end(),
                       [&](const double one) { return one == value; });
  };
  if (are_all(strengths.tensile, 0.))
    strengths.tensile.clear();
  if (!compressive.empty() || !pair_compressive.empty())
    strengths.compressive = means(
        packing,
        {"compressive strength", "Contact", compressive, "Compressive strength",
         pair_compressive, "Pair compressive strengths", true, true},
        strengths.warnings);
  if (are_all(strengths.compressive, std::numeric_limits<double>::infinity()))
    strengths.compressive.clear();
}
} // namespace Voussoir
