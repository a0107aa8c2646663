// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/assigned_entries.h>
#include <voussoir/base/parameters/parameter_path.h>
#include <voussoir/base/parameters/parameter_tree.h>

namespace Voussoir
{
void AssignedEntries::watch(dealii::ParameterHandler &prm)
{
  entries = tree_of(prm);
  for_each_entry(
      entries, [&](const std::string &path, nlohmann::ordered_json &node) {
        const auto &[section, entry] = entry_path_of(path);
        const InSection in_section(prm, section);
        prm.add_action(entry, [this, path, &node](const std::string &value) {
          node.at("value") = value;
          paths.insert(path);
        });
      });
  // Each action has been called with the present value, which is the default.
  paths.clear();
}

void AssignedEntries::forget_unchanged()
{
  for_each_entry(entries, [&](const std::string &path, const auto &entry) {
    if (!is_changed(entry))
      paths.erase(path);
  });
}
} // namespace Voussoir
