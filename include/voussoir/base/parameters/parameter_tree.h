// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_parameter_tree_h
#define voussoir_base_parameters_parameter_tree_h

#include <deal.II/base/parameter_handler.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <nlohmann/json.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace Voussoir
{
/** All sections and entries in their order, as deal.II writes them as JSON. */
inline nlohmann::ordered_json tree_of(const dealii::ParameterHandler &prm)
{
  std::stringstream text;
  prm.print_parameters(text,
                       dealii::ParameterHandler::JSON |
                           dealii::ParameterHandler::KeepDeclarationOrder);
  return nlohmann::ordered_json::parse(text);
}

/** True if a node of it is an entry, and not a section. */
inline bool is_entry(const nlohmann::ordered_json &node)
{
  return node.contains("pattern_description");
}

/** The description of its pattern as deal.II has it, without uses_in(). */
inline std::string description_of_pattern(const nlohmann::ordered_json &entry)
{
  const std::string description = entry.at("pattern_description");
  return description.substr(0, description.rfind(']') + 1);
}

/** True if an entry has another value than its default; 1.0 is 1. */
inline bool is_changed(const nlohmann::ordered_json &entry)
{
  const std::string value = entry.at("value");
  const std::string fallback = entry.at("default_value");
  if (value == fallback)
    return false;
  double a, b;
  return !(boost::conversion::try_lexical_convert(value, a) &&
           boost::conversion::try_lexical_convert(fallback, b) && a == b);
}

/**
 * Call @p action with the path of each entry in a section, "Friction/Strength",
 * and the entry, in their order.
 *
 * @param path of the section, with a slash at its end; nothing of the tree.
 */
template <typename Node, typename Action>
void for_each_entry(Node &section,
                    const Action &action,
                    const std::string &path = "")
{
  if (!section.is_object()) // boost writes a section without entries as ""
    return;
  for (auto node = section.begin(); node != section.end(); ++node)
    if (is_entry(*node))
      action(path + node.key(), *node);
    else
      for_each_entry(*node, action, path + node.key() + '/');
}

/** Add the paths of all sections in a section to @p paths. */
inline void add_sections(const nlohmann::ordered_json &section,
                         std::vector<std::string> &paths,
                         const std::string &path = "")
{
  if (!section.is_object())
    return;
  for (const auto &[name, node] : section.items())
    if (!is_entry(node))
    {
      paths.push_back(path + name);
      add_sections(node, paths, path + name + '/');
    }
}

/** The values of all entries in a section, or of an entry, a line each. */
inline std::string values_in(const nlohmann::ordered_json &node)
{
  if (node.is_object() && is_entry(node))
    return node.at("value").get<std::string>() + '\n';
  std::string values;
  for_each_entry(node, [&](const std::string &, const auto &entry) {
    values += entry.at("value").template get<std::string>() + '\n';
  });
  return values;
}
} // namespace Voussoir

#endif
