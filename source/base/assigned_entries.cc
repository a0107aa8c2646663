// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/assigned_entries.h>
#include <voussoir/base/parameter_tree.h>

#include <deal.II/base/utilities.h>

#include <vector>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;
} // namespace

void AssignedEntries::watch(dealii::ParameterHandler &prm)
{
  entries = tree_of(prm);
  for_each_entry(entries, [&](const std::string &path, Json &node) {
    std::vector<std::string> sections =
        dealii::Utilities::split_string_list(path, '/');
    const std::string entry = sections.back();
    sections.pop_back();
    for (const std::string &section : sections)
      prm.enter_subsection(section);
    prm.add_action(entry, [this, path, &node](const std::string &value) {
      node.at("value") = value;
      paths.insert(path);
    });
    for (std::size_t k = 0; k < sections.size(); ++k)
      prm.leave_subsection();
  });
  // Each action has been called with the present value, which is the default.
  paths.clear();
}

void AssignedEntries::forget_unchanged()
{
  for_each_entry(entries, [&](const std::string &path, const Json &entry) {
    if (!is_changed(entry))
      paths.erase(path);
  });
}
} // namespace Voussoir
