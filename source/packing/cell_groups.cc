// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/formula/expression.h>
#include <voussoir/packing/cell_groups.h>
#include <voussoir/packing/group_names.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>

namespace Voussoir
{
unsigned int group_of_name(const Packing &packing,
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

void assign_groups(Packing &packing, const std::string &groups)
{
  const std::string parameter = "Packing/Groups";
  for (const auto &[name, condition] : split_named_list(groups, parameter))
  {
    const Condition holds(condition, {"x", "y"}, parameter);
    bool any = false;
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      if (holds({packing.centre(c)[0], packing.centre(c)[1]}))
      {
        packing.set_group(c, name);
        any = true;
      }
    if (!any)
      throw InputError("The condition '" + condition + "' of the group '" +
                       name +
                       "' in 'Packing/Groups' is met by no cell; change it, or "
                       "leave the group out. x and y are the coordinates of a "
                       "cell's centre.");
  }
}
} // namespace Voussoir
