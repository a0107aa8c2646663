// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/scene/links/link.h>

#include <utility>

namespace Voussoir
{
void check_link_name(const std::string &section, const std::string &name)
{
  const std::string fault = fault_of_group_name(name);
  if (!fault.empty())
    throw InputError("The section " + quoted_group_name(name) + " in '" +
                     section + "' has a name that " + fault +
                     "; choose another.");
}

std::vector<unsigned int> linked_groups(const Packing<2> &packing,
                                        const std::vector<Link> &links,
                                        const Ground ground)
{
  std::vector<std::pair<unsigned int, unsigned int>> pairs;
  for (const Link &link : links)
    pairs.emplace_back(link.cell_minus, link.cell_plus);
  return connected_groups(packing, ground, pairs);
}

std::vector<Link> without_rest(std::vector<Link> links)
{
  for (Link &link : links)
  {
    const double rest = link.rest();
    link.least -= rest;
    link.most -= rest;
  }
  return links;
}
} // namespace Voussoir
