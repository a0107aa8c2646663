// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/contact/contact_parameters.h>

#include <algorithm>
#include <limits>

namespace Voussoir
{
namespace
{
/** Refuse tension at which Coulomb's friction admits no forces at all. */
template <int dim>
void check_tension(const Packing<dim> &packing, const Strengths &strengths)
{
  for (unsigned int e = 0; e < strengths.coefficient.size(); ++e)
  {
    const auto &i = packing.interfaces()[e];
    const double cohesion = strengths.of_interface[e];
    const double least = strengths.coefficient[e] * strengths.tensile[e];
    if (least > cohesion)
      throw InputError(
          text("The tensile strength of the interface of ",
               packing.describe(i.cell_minus), " and ",
               packing.describe(i.cell_plus), " at ", text_of_point(i.middle()),
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
  prm.enter_subsection("Contact");
  tensile.add_parameters(
      prm,
      "The tensile strength f_t of the interfaces, the tensile "
      "stress at which they open. Not negative; an expression in "
      "x, y and the unit normal nx, ny as for "
      "'Friction/Strength'. With Coulomb's friction at most "
      "'Cohesion' over 'Coefficient'.",
      "Other tensile strengths where two groups of cells meet, "
      "as for 'Friction/Pair strengths'.");
  compressive.add_parameters(
      prm,
      "The compressive strength f_c of the interfaces, the "
      "compressive stress at which they crush: no normal force "
      "is larger than f_c |e|, and where blocks turn than "
      "f_c (|e| - 2 |e_N|) with the eccentricity e_N. Positive; "
      "an expression as above. Empty: interfaces do not crush.",
      "Other compressive strengths where two groups of cells "
      "meet, as above.");
  prm.leave_subsection();
}

template <int dim>
void ContactParameters::add_strengths(const Packing<dim> &packing,
                                      Strengths &strengths) const
{
  strengths.tensile = means(packing, tensile, strengths.warnings);
  check_tension(packing, strengths);
  const auto are_all = [](const auto &of, const double value) {
    return std::all_of(of.begin(), of.end(),
                       [&](const double one) { return one == value; });
  };
  if (are_all(strengths.tensile, 0.))
    strengths.tensile.clear();
  if (!compressive.everywhere.empty() || !compressive.of_pairs.empty())
    strengths.compressive = means(packing, compressive, strengths.warnings);
  if (are_all(strengths.compressive, std::numeric_limits<double>::infinity()))
    strengths.compressive.clear();
}

template void ContactParameters::add_strengths(const Packing<2> &,
                                               Strengths &) const;
template void ContactParameters::add_strengths(const Packing<3> &,
                                               Strengths &) const;
} // namespace Voussoir
