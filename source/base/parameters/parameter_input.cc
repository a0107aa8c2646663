// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/nested_parameters.h>
#include <voussoir/base/parameters/parameter_faults.h>
#include <voussoir/base/parameters/parameter_input.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text_file.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <optional>
#include <regex>
#include <sstream>

namespace Voussoir
{
namespace
{
/** True if a line of @p text is listing_title(). */
bool is_listing(const std::string &text)
{
  const std::string title = listing_title();
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (line == title)
      return true;
  return false;
}

/** deal.II would look for an included file in the working directory. */
void refuse_includes(const std::string &lines, const std::string &name)
{
  std::istringstream in(lines);
  std::string line;
  for (unsigned int number = 1; std::getline(in, line); ++number)
  {
    std::istringstream words(line);
    std::string first;
    words >> first;
    if (first == "include" || first == "INCLUDE")
      throw InputError("Line " + std::to_string(number) + " of '" + name +
                       "' includes another file; give all parameters in one, "
                       "or on the command line with --set.");
  }
}
} // namespace

std::string listing_title()
{
  std::stringstream listing;
  dealii::ParameterHandler().print_parameters(listing,
                                              dealii::ParameterHandler::PRM);
  std::string title;
  std::getline(listing, title);
  return title;
}

ParameterInput::ParameterInput(const std::filesystem::path &file)
    : name(file.string())
{
  const std::optional<std::string> text = read_text_file(file);
  if (!text)
    throw InputError("The parameter file '" + name +
                     "' cannot be read. Give the path of a .prm, .json or .xml "
                     "file, such as prm/shear_wall.prm.");
  const std::string ending =
      boost::algorithm::to_lower_copy(file.extension().string());
  if (ending == ".json")
    content = nested_from_json(*text, name);
  else if (ending == ".xml")
    content = nested_from_xml(*text, name);
  else
    content = *text;
}

ParameterInput::ParameterInput(const std::string &lines,
                               const std::string &name)
    : name(name), content(lines)
{}

std::set<std::string>
ParameterInput::sections_in(const std::string &section) const
{
  std::set<std::string> names;
  if (const auto *const lines = std::get_if<std::string>(&content))
  {
    for (const SectionOfText &found : sections_before(*lines))
      if (found.path.size() == 2 && found.path[0] == section)
        names.insert(found.path[1]);
    return names;
  }
  for (const auto &[outer, inner] : std::get<Nested>(content))
    for (const auto &[name, node] : inner)
      if (outer == section)
        names.insert(name);
  return names;
}

std::optional<std::string>
ParameterInput::value_of(const std::string &entry) const
{
  if (const auto *const nested = std::get_if<Nested>(&content))
  {
    const auto node = nested->get_child_optional(entry);
    if (!node)
      return {};
    return node->get("value", node->data());
  }
  // Not by deal.II, which would take what it does not know for a mistake.
  const std::regex begins("\\s*subsection\\s.*", std::regex::icase);
  const std::regex ends("\\s*end\\s*(#.*)?", std::regex::icase);
  const std::regex assigns(
      "\\s*set\\s+" + entry + "\\s*=\\s*([^#]*?)\\s*(#.*)?", std::regex::icase);
  std::optional<std::string> value;
  std::istringstream in(std::get<std::string>(content));
  std::smatch match;
  int depth = 0;
  for (std::string line; std::getline(in, line);)
    if (std::regex_match(line, begins))
      ++depth;
    else if (std::regex_match(line, ends))
      --depth;
    else if (depth == 0 && std::regex_match(line, match, assigns))
      value = match[1];
  return value;
}

bool ParameterInput::assign_to(dealii::ParameterHandler &prm) const
{
  if (const auto *const nested = std::get_if<Nested>(&content))
    return assign_nested(prm, *nested, "'" + name + "'");
  const std::string &lines = std::get<std::string>(content);
  refuse_includes(lines, name);
  std::istringstream in(lines);
  try
  {
    prm.parse_input(in, name);
  }
  catch (const dealii::ExceptionBase &fault)
  {
    throw InputError(explain_fault(prm, fault, {lines, name}) + " " +
                     how_to_list_parameters);
  }
  return is_listing(lines);
}
} // namespace Voussoir
