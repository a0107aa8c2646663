// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/nearest_name.h>
#include <voussoir/base/parameters/decimal_comma.h>
#include <voussoir/base/parameters/faulty_assignment.h>
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/base/parameters/pattern_description.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** The most characters of a value in a message. */
constexpr std::size_t longest_value = 80;

/** The paths that are directly in a section. */
std::vector<std::string> directly_in(const std::string &section,
                                     std::vector<std::string> paths)
{
  const auto is_elsewhere = [&](const std::string &path) {
    return path.substr(0, path.rfind('/') + 1) != section;
  };
  paths.erase(std::remove_if(paths.begin(), paths.end(), is_elsewhere),
              paths.end());
  return paths;
}
} // namespace

std::string shortened(const std::string &words)
{
  return words.size() > longest_value ? words.substr(0, longest_value) + "..."
                                      : words;
}

std::string FaultyAssignment::unknown_section(const std::string &name) const
{
  return "there is no section '" + shortened(name) + "' here" +
         did_you_mean(name, paths(true));
}

std::string FaultyAssignment::unknown_entry(const std::string &name) const
{
  return "there is no parameter '" + shortened(name) + "' in this section" +
         did_you_mean(name, paths(false));
}

std::string FaultyAssignment::unaccepted_value(const std::string &name,
                                               const std::string &value,
                                               const std::string &pattern) const
{
  const std::string with_points = with_decimal_points(value);
  return "'" + shortened(name) + "' is '" + shortened(value) +
         "', but must be " + text_of_pattern(pattern) +
         (with_points != value && accepts(name, with_points)
              ? advice_on_decimal_comma(shortened(value))
              : "") +
         ".";
}

std::string FaultyAssignment::unaccepted_value(const std::string &name,
                                               const std::string &value) const
{
  const nlohmann::ordered_json tree = tree_of(prm);
  const nlohmann::ordered_json *node = &tree;
  for (const std::string &around : section)
    node = &node->at(around);
  return unaccepted_value(name, value,
                          node->at(name).at("pattern_description"));
}

std::vector<std::string> FaultyAssignment::paths(const bool of_sections) const
{
  const nlohmann::ordered_json tree = tree_of(prm);
  std::vector<std::string> all;
  if (of_sections)
    add_sections(tree, all);
  else
    for_each_entry(tree, [&](const std::string &path, const auto &) {
      all.push_back(path);
    });
  return all;
}

bool FaultyAssignment::accepts(const std::string &name,
                               const std::string &value) const
{
  const InSection in_section(prm, section);
  try
  {
    prm.set(name, value);
    return true;
  }
  catch (const std::exception &)
  {
    return false;
  }
}

/**
 * "; did you mean 'Friction/Strength'?", or ".": one in this section, one with
 * the section's name as its first word, or one anywhere. Of a name that exists
 * outside of the section it says so.
 */
std::string
FaultyAssignment::did_you_mean(const std::string &name,
                               const std::vector<std::string> &paths) const
{
  if (std::find(paths.begin(), paths.end(), name) != paths.end())
    return ", but there is one outside of all sections.";
  std::vector<std::string> nearest =
      nearest_names(name, directly_in(text_of_section(section), paths));
  if (nearest.empty() && !section.empty())
    nearest = nearest_names(section.back() + ' ' + name, paths);
  if (nearest.empty())
    nearest = nearest_names(name, paths);
  std::string names;
  for (const std::string &path : nearest)
    names += (names.empty() ? "'" : " or '") + path + '\'';
  return names.empty() ? "." : "; did you mean " + names + '?';
}
} // namespace Voussoir
