// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/range_entries.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/formula/expression.h>
#include <voussoir/formula/place_variables.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/group_names.h>

#include <deal.II/base/patterns.h>

#include <vector>

namespace Voussoir
{
namespace
{
const std::string parameter_where = "Ranges/Where";
const std::string parameter_joints = "Ranges/Joints";

/** Choose the interfaces where the condition holds. */
template <int dim>
void choose_where(const Packing<dim> &packing,
                  const std::string &where,
                  const Condition &holds,
                  std::vector<bool> &chosen)
{
  bool any = false;
  for (unsigned int e = 0; e < chosen.size(); ++e)
  {
    const auto &i = packing.interfaces()[e];
    std::vector<double> values;
    for (unsigned int d = 0; d < dim; ++d)
      values.push_back(i.middle()[d]);
    for (unsigned int d = 0; d < dim; ++d)
      values.push_back(i.normal[d]);
    chosen[e] = holds(values);
    any |= chosen[e];
  }
  if (!any && dim == 2)
    throw InputError("The condition '" + where + "' of '" + parameter_where +
                     "' holds on no interface. It is asked at the midpoint x, "
                     "y of each, with its unit normal nx, ny; where rounding "
                     "matters write y < 1e-9 rather than y == 0.");
  if (!any)
    throw InputError("The condition '" + where + "' of '" + parameter_where +
                     "' holds on no interface. It is asked at the centroid x, "
                     "y, z of each, with its unit normal nx, ny, nz; where "
                     "rounding matters write z < 1e-9 rather than z == 0.");
}

/** For each cell and the ground, whether it has the name. */
template <int dim>
std::vector<bool> are_named(const Packing<dim> &packing,
                            const std::string &name)
{
  std::vector<bool> named(packing.n_cells() + 1, false);
  for (const unsigned int c : cells_of_name(packing, name, parameter_joints))
    named[c] = true;
  return named;
}

/** Choose the interfaces of one name, or between two. */
template <int dim>
void choose_named(const Packing<dim> &packing,
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

template <int dim>
void RangeEntries::add_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Ranges");
  prm.add_parameter(
      "Where", where,
      "The interfaces of which the least and the greatest normal and "
      "tangential force are found, over all admissible states that carry the "
      "loads: those at whose " +
          std::string(dim == 2
                          ? "midpoint x, y, with the unit normal nx, ny, this "
                            "expression is not zero. Each takes four linear "
                            "programmes, from thousandths of a second each "
                            "with hundreds of cells to seconds with tens of "
                            "thousands. 1: all. 0: none."
                          : "centroid x, y, z, with the unit normal nx, ny, "
                            "nz, this expression is not zero; of tangential "
                            "forces that of each component. Each takes up to "
                            "eight conic programmes, each of which takes about "
                            "as long as a load factor. 1: all. 0: none."),
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
      dim == 2 ? "true: also find the least and the greatest reaction of each "
                 "straight support, in x (the thrust, if x is horizontal) and "
                 "in y."
               : "true: also find the least and the greatest reaction of each "
                 "support, in x, y and z; supports in one plane below cells "
                 "that touch are one.",
      dealii::Patterns::Bool());
  if constexpr (dim == 2)
  {
    prm.add_parameter("Links", links,
                      "true: also find the least and the greatest force of "
                      "each of the 'Ties': what a tie must bear at least, and "
                      "what it may be made to bear.",
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
          "each end: for few forces of large packings. Reactions of supports "
          "of "
          "several interfaces are left to the simplex method."}},
        "How they are found.");
  }
  prm.leave_subsection();
}

template <int dim>
std::optional<RangesWanted>
RangeEntries::wanted(const Packing<dim> &packing) const
{
  const Condition holds(where, variables_on_sides<dim>(), parameter_where);
  RangesWanted wanted = {std::vector<bool>(packing.interfaces().size(), false),
                         reactions, method, links};
  if (reactions && packing.n_supports() == 0)
    throw InputError("'Ranges/Reactions' is true, and there are no supports: "
                     "'Supports/Where' gives them.");
  if (!holds.is_never())
    choose_where(packing, where, holds, wanted.interfaces);
  if (!joints.empty())
    for (const std::string &names : split_at_bars(joints))
      choose_named(packing, names, wanted.interfaces);
  if (holds.is_never() && joints.empty() && !reactions && !links)
    return {};
  return wanted;
}

template void RangeEntries::add_parameters<2>(dealii::ParameterHandler &);
template void RangeEntries::add_parameters<3>(dealii::ParameterHandler &);
template std::optional<RangesWanted>
RangeEntries::wanted(const Packing<2> &) const;
template std::optional<RangesWanted>
RangeEntries::wanted(const Packing<3> &) const;
} // namespace Voussoir
