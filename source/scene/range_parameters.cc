// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/expression.h>
#include <voussoir/scene/range_parameters.h>

#include <deal.II/base/patterns.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
constexpr unsigned int least_number_of_samples = 100;
} // namespace

void RangeParameters::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Ranges");
  prm.add_parameter(
      "Where", where,
      "The interfaces of which the least and the greatest normal and "
      "tangential force are found, over all admissible states that carry the "
      "loads: those at whose midpoint x, y, with the unit normal nx, ny, this "
      "expression is not zero. Each takes four linear programmes, from "
      "thousandths of a second each with hundreds of cells to seconds with "
      "tens of thousands. 1: all. 0: none.",
      dealii::Patterns::Anything());
  prm.add_parameter(
      "Reactions", reactions,
      "true: also find the least and the greatest reaction of each straight "
      "support, in x (the thrust, if x is horizontal) and in y.",
      dealii::Patterns::Bool());
  add_choice<RangeMethod>(
      prm, "Method", method,
      {{RangeMethod::automatic, "automatic",
        "the one that is likely to be the quicker."},
       {RangeMethod::simplex, "simplex",
        "the simplex method, which goes from the end of one range to that of "
        "the next: for many forces."},
       {RangeMethod::interior_point, "interior point",
        "an interior point, which takes about as long as a load factor for "
        "each end: for few forces of large packings. Reactions of supports of "
        "several interfaces are left to the simplex method."}},
      "How they are found.");
  prm.add_parameter(
      "Samples", of_samples.n,
      "The number of states that are drawn from all admissible ones, with "
      "equal probability for equal volumes of the set of forces, to have the "
      "mean and the spread of each force. 0: none; else at least 100.",
      dealii::Patterns::Integer(0));
  prm.add_parameter(
      "Steps between samples", of_samples.n_steps,
      "The number of steps of the random walk from one sample to the next; the "
      "more, the less they depend on each other. 0: the dimension of the set.",
      dealii::Patterns::Integer(0));
  prm.add_parameter("Seed", of_samples.seed,
                    "Of the random numbers: equal seeds give equal samples.",
                    dealii::Patterns::Integer(0));
  prm.leave_subsection();
}

std::optional<SamplesWanted> RangeParameters::samples() const
{
  if (of_samples.n == 0)
    return {};
  if (of_samples.n < least_number_of_samples)
    throw InputError(text("'Ranges/Samples' = '", of_samples.n,
                          "' must be 0 or at least ", least_number_of_samples,
                          ": fewer tell no spread."));
  return of_samples;
}

std::optional<RangesWanted>
RangeParameters::wanted(const Packing &packing) const
{
  const std::string parameter = "Ranges/Where";
  const Condition holds(where, {"x", "y", "nx", "ny"}, parameter);
  RangesWanted wanted = {std::vector<bool>(packing.interfaces().size(), false),
                         reactions, method};
  if (reactions && packing.n_supports() == 0)
    throw InputError("'Ranges/Reactions' is true, and there are no supports: "
                     "'Supports/Where' gives them.");
  if (holds.is_never())
    return reactions ? std::make_optional(wanted) : std::nullopt;
  for (unsigned int e = 0; e < wanted.interfaces.size(); ++e)
  {
    const Packing::Interface &i = packing.interfaces()[e];
    const dealii::Point<2> x = i.midpoint();
    wanted.interfaces[e] = holds({x[0], x[1], i.normal[0], i.normal[1]});
  }
  if (std::find(wanted.interfaces.begin(), wanted.interfaces.end(), true) ==
      wanted.interfaces.end())
    throw InputError("The condition '" + where + "' of '" + parameter +
                     "' holds on no interface. It is asked at the midpoint x, "
                     "y of each, with its unit normal nx, ny; where rounding "
                     "matters write y < 1e-9 rather than y == 0.");
  return wanted;
}
} // namespace Voussoir
