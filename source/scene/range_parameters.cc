// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/expression.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/scene/range_parameters.h>

#include <deal.II/base/patterns.h>

namespace Voussoir
{
namespace
{
constexpr unsigned int least_number_of_samples = 100;
const std::string parameter_where = "Ranges/Where";
const std::string parameter_joints = "Ranges/Joints";

/** Choose the interfaces where the condition holds. */
void choose_where(const Packing &packing,
                  const std::string &where,
                  const Condition &holds,
                  std::vector<bool> &chosen)
{
  bool any = false;
  for (unsigned int e = 0; e < chosen.size(); ++e)
  {
    const Packing::Interface &i = packing.interfaces()[e];
    const dealii::Point<2> x = i.midpoint();
    chosen[e] = holds({x[0], x[1], i.normal[0], i.normal[1]});
    any |= chosen[e];
  }
  if (!any)
    throw InputError("The condition '" + where + "' of '" + parameter_where +
                     "' holds on no interface. It is asked at the midpoint x, "
                     "y of each, with its unit normal nx, ny; where rounding "
                     "matters write y < 1e-9 rather than y == 0.");
}

/** For each cell and the ground, whether it has the name. */
std::vector<bool> are_named(const Packing &packing, const std::string &name)
{
  std::vector<bool> named(packing.n_cells() + 1, false);
  for (const unsigned int c : cells_of_name(packing, name, parameter_joints))
    named[c] = true;
  return named;
}

/** Choose the interfaces of one name, or between two. */
void choose_named(const Packing &packing,
                  const std::string &names,
                  std::vector<bool> &chosen)
{
  const std::vector<std::string> words = split_names(names);
  if (words.size() > 2 || words.front().empty() || words.back().empty())
    throw InputError("The parameter '" + parameter_joints + "' has '" + names +
                     "' where one or two names are expected, as in \"keystone "
                     "| pier, ground\".");
  const std::vector<bool> one = are_named(packing, words.front());
  const std::vector<bool> other = words.size() == 2
                                      ? are_named(packing, words.back())
                                      : std::vector<bool>(one.size(), true);
  bool any = false;
  for (unsigned int e = 0; e < chosen.size(); ++e)
  {
    const unsigned int a = packing.interfaces()[e].cell_minus;
    const unsigned int b = packing.interfaces()[e].cell_plus;
    if (!((one[a] && other[b]) || (one[b] && other[a])))
      continue;
    chosen[e] = true;
    any = true;
  }
  if (!any)
    throw InputError("The parameter '" + parameter_joints + "' names '" +
                     names +
                     "', and there is no interface of that name; change it, "
                     "or leave it out.");
}
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
      "Joints", joints,
      "Interfaces by name, besides: of the cells of a group, or of a cell with "
      "a number, with all that touch them, as in keystone or cell 12; or "
      "between two of these, as in brick, lintel or cell 3, cell 4 or pier, "
      "ground. Several are separated by bars: keystone | pier, ground.",
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
      "States are drawn from all admissible ones, with equal probability for "
      "equal volumes of the set of forces, to have the mean and the spread of "
      "each force: so many that the mean of each is worth that of this number "
      "of independent states. 0: none; else at least 100, of which at least "
      "400 are made.",
      dealii::Patterns::Integer(0));
  prm.add_parameter(
      "Steps between samples", of_samples.n_steps,
      "The number of steps of the random walk from one sample to the next; the "
      "more, the less they depend on each other. 0: as many as it takes, by "
      "what the samples themselves tell, up to 256. Else as many samples are "
      "drawn as 'Samples' says, whatever they are worth.",
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
  const Condition holds(where, {"x", "y", "nx", "ny"}, parameter_where);
  RangesWanted wanted = {std::vector<bool>(packing.interfaces().size(), false),
                         reactions, method};
  if (reactions && packing.n_supports() == 0)
    throw InputError("'Ranges/Reactions' is true, and there are no supports: "
                     "'Supports/Where' gives them.");
  if (!holds.is_never())
    choose_where(packing, where, holds, wanted.interfaces);
  if (!joints.empty())
    for (const std::string &names : split_at_bars(joints))
      choose_named(packing, names, wanted.interfaces);
  if (holds.is_never() && joints.empty() && !reactions)
    return {};
  return wanted;
}
} // namespace Voussoir
