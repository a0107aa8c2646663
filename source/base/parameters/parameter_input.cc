// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/nested_parameters.h>
#include <voussoir/base/parameters/parameter_faults.h>
#include <voussoir/base/parameters/parameter_input.h>
#include <voussoir/base/parameters/parameter_lines.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/printable.h>
#include <voussoir/base/text.h>
#include <voussoir/base/text_file.h>

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <optional>
#include <sstream>

namespace Voussoir
{
namespace
{
using dealii::Utilities::trim;

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
bool is_set(const std::string &word)
{
  return boost::iequals(word, "set");
}

bool is_directly_in(const std::string &section,
                    const std::vector<std::string> &sections)
{
  return section.empty() ? sections.empty()
                         : sections.size() == 1 && sections[0] == section;
}

using Nested = boost::property_tree::ptree;

/** What is directly in a section, or outside all. */
const Nested &section_of(const Nested &nested, const std::string &section)
{
  static const Nested nothing;
  if (section.empty())
    return nested;
  const auto found = nested.find(section);
  return found == nested.not_found() ? nothing : found->second;
}

/** Values are written to JSON, and shown on pages. */
void refuse_other_encoding(const std::string &text, const std::string &place)
{
  if (!is_utf8(text))
    throw InputError(place + " is not UTF-8 text: " + trim(text) +
                     "; save the file as UTF-8, which editors offer as the "
                     "encoding.");
}

/** In lines, of which comments may be in any. */
void refuse_other_encoding_of_lines(const std::string &lines,
                                    const std::string &name)
{
  if (is_utf8(lines))
    return;
  std::istringstream in(lines);
  std::string line;
  for (unsigned int number = 1; std::getline(in, line); ++number)
    refuse_other_encoding(line.substr(0, line.find('#')),
                          text("Line ", number, " of '", name, "'"));
}

void refuse_other_encoding_of_nested(const Nested &node,
                                     const std::string &path,
                                     const std::string &file)
{
  refuse_other_encoding(node.data(), "'" + path + "' of '" + file + "'");
  for (const auto &[name, inner] : node)
    refuse_other_encoding_of_nested(
        inner, path.empty() ? name : path + '/' + name, file);
}

/** Replace the values in a node. @param path of it, without the last '. */
template <typename Replaced>
void replace_nested(Nested &node,
                    const std::string &path,
                    const std::string &file,
                    const Replaced &replaced)
{
  node.data() = replaced(node.data(), file + path + '\'');
  for (auto &[name, inner] : node)
    replace_nested(inner, path + '/' + name, file, replaced);
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
  check_encoding();
}

ParameterInput::ParameterInput(const std::string &lines,
                               const std::string &name)
    : name(name), content(lines)
{
  check_encoding();
}

void ParameterInput::check_encoding() const
{
  if (const auto *const lines = std::get_if<std::string>(&content))
    refuse_other_encoding_of_lines(*lines, name);
  else
    refuse_other_encoding_of_nested(std::get<Nested>(content), "", name);
}

std::set<std::string>
ParameterInput::sections_in(const std::string &section) const
{
  std::set<std::string> names;
  if (const auto *const lines = std::get_if<std::string>(&content))
  {
    for_each_line(*lines, [&](const std::vector<std::string> &sections,
                              const std::string &line, unsigned int) {
      if (const auto name = section_begun_by(line);
          name && is_directly_in(section, sections))
        names.insert(*name);
    });
    return names;
  }
  for (const auto &[outer, inner] : std::get<Nested>(content))
    for (const auto &[name, node] : inner)
      if (outer == section)
        names.insert(name);
  return names;
}

ParameterInput::Entries
ParameterInput::entries_in(const std::string &section) const
{
  Entries entries;
  if (const auto *const nested = std::get_if<Nested>(&content))
  {
    for (const auto &[name, node] : section_of(*nested, section))
      if (node.empty() || node.count("value") > 0)
        entries.emplace_back(name, node.get("value", node.data()));
    return entries;
  }
  // Not by deal.II, which would take what it does not know for a mistake.
  for_each_line(std::get<std::string>(content),
                [&](const std::vector<std::string> &sections,
                    const std::string &line, unsigned int) {
                  const std::string words = statement_of_line(line);
                  const std::string first = first_word(words);
                  const std::size_t equals = words.find('=');
                  if (is_directly_in(section, sections) && is_set(first) &&
                      equals != std::string::npos)
                    entries.emplace_back(
                        trim(words.substr(first.size(), equals - first.size())),
                        trim(words.substr(equals + 1)));
                });
  return entries;
}

void ParameterInput::replace_values(
    const std::string &section,
    const std::function<std::string(const std::string &, const std::string &)>
        &replaced)
{
  if (auto *const nested = std::get_if<Nested>(&content))
  {
    for (auto &[name, node] : *nested)
      if (name != section)
        replace_nested(node, '\'' + name, "'" + this->name + "', ", replaced);
    return;
  }
  std::string lines;
  for_each_line(std::get<std::string>(content),
                [&](const std::vector<std::string> &sections,
                    const std::string &line, const unsigned int number) {
                  const std::string before = line.substr(0, line.find('#'));
                  const bool stays =
                      !sections.empty() && sections[0] == section;
                  lines += stays ? line
                                 : replaced(before, text("Line ", number,
                                                         " of '", name, "'")) +
                                       line.substr(before.size());
                  lines += '\n';
                });
  content = lines;
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
