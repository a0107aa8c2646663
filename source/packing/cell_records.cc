// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/cell_records.h>
#include <voussoir/packing/group_names.h>

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

std::string CellRecords::describe(const unsigned int cell) const
{
  std::string name = text("cell ", cell);
  if (!records.empty())
    name += text(" (", record_name, ' ', records[cell], " of '", file, "')");
  return name;
}
} // namespace Voussoir
