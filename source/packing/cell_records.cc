// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/cell_records.h>
#include <voussoir/packing/group_names.h>

#include <algorithm>

namespace Voussoir
{
void CellRecords::name_groups()
{
  if (group_names.empty())
    group_names = {"block"};
  for (const std::string &name : group_names)
    check_group_name(name);
  group_names.push_back(ground_name);
}

unsigned int CellRecords::group_of(const unsigned int cell,
                                   const unsigned int ground) const
{
  if (cell >= ground)
    return group_names.size() - 1;
  return group.empty() ? 0 : group[cell];
}

void CellRecords::set_group(const unsigned int cell,
                            const std::string &name,
                            const unsigned int n_cells)
{
  check_group_name(name);
  group.resize(n_cells, 0);
  auto found = std::find(group_names.begin(), group_names.end() - 1, name);
  if (found == group_names.end() - 1)
    found = group_names.insert(found, name);
  group[cell] = found - group_names.begin();
}

std::string CellRecords::describe(const unsigned int cell) const
{
  std::string name = text("cell ", cell);
  if (!records.empty())
    name += text(" (", record_name, ' ', records[cell], " of '", file, "'",
                 cell < details.size() && !details[cell].empty()
                     ? ", " + details[cell]
                     : "",
                 ")");
  return name;
}
} // namespace Voussoir
