// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/expression.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/group_names.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** What the coordinates of a place are called in expressions. */
template <int dim>
std::vector<std::string> coordinate_names()
{
  const std::vector<std::string> names = {"x", "y", "z"};
  return {names.begin(), names.begin() + dim};
}
} // namespace

template <int dim>
unsigned int group_of_name(const Packing<dim> &packing,
                           const std::string &name,
                           const std::string &parameter)
{
  const auto &names = packing.group_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end())
    return found - names.begin();
  const std::string known = "'" + boost::algorithm::join(names, "', '") + "'";
  throw InputError("The parameter '" + parameter + "' names the group '" +
                   name + "', which no cell belongs to. There are " + known +
                   "; 'Packing/Groups' makes others.");
}

template <int dim>
std::vector<unsigned int> cells_of_name(const Packing<dim> &packing,
                                        const std::string &name,
                                        const std::string &parameter)
{
  if (const std::size_t blank = name.rfind(' ');
      blank != name.npos && is_name_of_cell(name))
  {
    unsigned int number = 0;
    if (!boost::conversion::try_lexical_convert(name.substr(blank + 1),
                                                number) ||
        number >= packing.n_cells())
      throw InputError(text("The parameter '", parameter, "' names '", name,
                            "', but the cells have the numbers from 0 to ",
                            packing.n_cells() - 1, "."));
    return {number};
  }
  const unsigned int group = group_of_name(packing, name, parameter);
  std::vector<unsigned int> cells;
  for (unsigned int c = 0; c <= packing.ground(); ++c)
    if (packing.group(c) == group)
      cells.push_back(c);
  return cells;
}

template <int dim>
void assign_groups(Packing<dim> &packing, const std::string &groups)
{
  const std::string parameter = "Packing/Groups";
  for (const auto &[name, condition] : split_named_list(groups, parameter))
  {
    const Condition holds(condition, coordinate_names<dim>(), parameter);
    bool any = false;
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
    {
      const dealii::Point<dim> &x = packing.centre(c);
      if (holds({x.begin_raw(), x.end_raw()}))
      {
        packing.set_group(c, name);
        any = true;
      }
    }
    if (!any)
      throw InputError(
          "The condition '" + condition + "' of the group '" + name +
          "' in 'Packing/Groups' is met by no cell; change it, or "
          "leave the group out. " +
          (dim == 2 ? "x and y are the coordinates of a cell's centre."
                    : "x, y and z are the coordinates of a cell's "
                      "centre."));
  }
}

template unsigned int
group_of_name(const Packing<2> &, const std::string &, const std::string &);
template unsigned int
group_of_name(const Packing<3> &, const std::string &, const std::string &);
template std::vector<unsigned int>
cells_of_name(const Packing<2> &, const std::string &, const std::string &);
template std::vector<unsigned int>
cells_of_name(const Packing<3> &, const std::string &, const std::string &);
template void assign_groups(Packing<2> &, const std::string &);
template void assign_groups(Packing<3> &, const std::string &);
} // namespace Voussoir
