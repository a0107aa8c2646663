// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/run/unused_settings.h>

#include <boost/algorithm/string/join.hpp>
#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <utility>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

/**
 * The search for unused settings, in sections with paths such as
 * "/Packing/wall". It is an exception if what is declared as used is not there.
 */
struct Search
{
  /** Look beside the entries of a section, and into those that are used. */
  void look_into(const std::string &path);
  /** Look at what the entry @p choice of the section @p path does not use. */
  void look_beside(const std::string &path,
                   const std::string &choice,
                   const Uses &uses);
  /** The names, in quotes, of the assigned entries of a section. */
  Names assigned_in(const std::string &path) const;
  bool is_assigned(const std::string &path) const
  {
    return assigned.contains(path.substr(1));
  }
  const Json &at(const std::string &path) const
  {
    return all.at(Json::json_pointer(path));
  }

  const Json &all;
  const AssignedEntries &assigned;
  std::set<std::string> unused_sections;
  /** Found, those on whole sections first, by the outermost section. */
  std::multimap<std::pair<bool, std::string>, std::string> sentences;
};

Names Search::assigned_in(const std::string &path) const
{
  Names names;
  if (at(path).is_object()) // boost writes a section without entries as ""
    for (const auto &[name, entry] : at(path).items())
      if (is_entry(entry) && is_assigned(path + '/' + name))
        names.push_back("'" + name + "'");
  return names;
}

void Search::look_into(const std::string &path)
{
  const Json &section = at(path);
  // With the forces of an earlier run no formulation is used at all, and the
  // file is that of the earlier run.
  const bool solves =
      !all.contains("Forces from") || at("/Forces from/value") == "";
  for (const auto &[name, node] : section.items())
    if (is_entry(node) && (solves || path + "/" + name != "/Formulation"))
      look_beside(path, name, uses_in(node.at("pattern_description")));
  for (const auto &[name, node] : section.items())
    if (node.is_object() && !is_entry(node) &&
        unused_sections.count(path + "/" + name) == 0)
      look_into(path + "/" + name);
}

void Search::look_beside(const std::string &path,
                         const std::string &choice,
                         const Uses &uses)
{
  const std::string chosen = at(path + "/" + choice).at("value");
  const auto add = [&](const bool single, const std::string &section,
                       const Names &entries) {
    if (!entries.empty())
      sentences.emplace(
          std::pair(single, section.substr(0, section.find('/', 1))),
          boost::algorithm::join(entries, ", ") +
              (section.empty() ? "" : " in '" + section.substr(1) + "'") +
              (entries.size() == 1 ? " has" : " have") + " no effect, since '" +
              (path + "/" + choice).substr(1) + "' is '" + chosen + "'.");
  };
  std::set<std::string> in_use;
  for (const auto &[value, names] : uses)
    if (value == chosen)
      in_use.insert(names.begin(), names.end());
  Names entries;
  for (const auto &[value, names] : uses)
    for (const std::string &name : names)
    {
      const std::string used = path + "/" + name;
      const Json &node = at(used);
      if (!in_use.insert(name).second) // in use, or named before
        continue;
      if (!is_entry(node))
      {
        unused_sections.insert(used);
        add(false, used, assigned_in(used));
      }
      else if (is_assigned(used))
        entries.push_back("'" + name + "'");
    }
  add(true, path, entries);
}
} // namespace

std::vector<std::string> unused_settings(const AssignedEntries &assigned)
{
  Search search{assigned.tree(), assigned, {}, {}};
  search.look_into("");
  Names sentences;
  for (const auto &[place, sentence] : search.sentences)
    sentences.push_back(sentence);
  return sentences;
}

NamesAndValues changed_settings(const dealii::ParameterHandler &prm)
{
  NamesAndValues changed;
  const Json tree = tree_of(prm);
  for_each_entry(tree, [&](const std::string &path, const Json &entry) {
    if (is_changed(entry))
      changed.emplace_back(path, entry.at("value"));
  });
  return changed;
}
} // namespace Voussoir
