// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/printable.h>
#include <voussoir/packing/group_names.h>

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cstring>

namespace Voussoir
{
const std::string ground_name = "ground";

namespace
{
/** True if a colon follows that is not the one of a conditional, "a ? b : c".
 */
bool begins_with_name(const std::string &text)
{
  return text.find(':') < text.find('?');
}

/** The elements "name: value" of a list. */
std::vector<std::string> split_elements(const std::string &list,
                                        const bool of_vectors)
{
  const std::vector<std::string> parts = split_at_bars(list);
  if (parts.size() > 1)
    return parts;
  std::vector<std::string> elements;
  for (const std::string &piece :
       dealii::Utilities::split_string_list(list, ';'))
    if (elements.empty() || !of_vectors || begins_with_name(piece))
      elements.push_back(piece);
    else
      elements.back() += "; " + piece;
  return elements;
}
} // namespace

bool is_name_of_cell(const std::string &name)
{
  // Not by std::regex, which takes a stack as deep as the name is long.
  const std::string cell = "cell";
  const std::size_t digits = name.find_first_not_of(' ', cell.size());
  return name.compare(0, cell.size(), cell) == 0 && digits < name.size() &&
         name.find_first_not_of("0123456789", digits) == name.npos;
}

std::string quoted_group_name(const std::string &name)
{
  return "'" + without_controls(name) + "'";
}

std::string fault_of_group_name(const std::string &name)
{
  const auto separates = [](const char letter) {
    return is_control(letter) || std::strchr(",;:\"", letter) != nullptr;
  };
  if (name.empty())
    return "is empty";
  if (name == ground_name)
    return "is the name of what supports the packing";
  if (is_name_of_cell(name))
    return "stands for a cell by its number";
  if (std::any_of(name.begin(), name.end(), separates))
    return "has a comma, semicolon, colon, quote or control character";
  if (!is_utf8(name))
    return "is not UTF-8 text";
  return "";
}

void check_group_name(const std::string &name)
{
  const std::string fault = fault_of_group_name(name);
  if (!fault.empty())
    throw InputError("The name " + quoted_group_name(name) +
                     " of a group of cells " + fault + "; choose another.");
}

std::vector<std::string> split_names(const std::string &names)
{
  std::vector<std::string> parts;
  boost::algorithm::split(parts, names, [](char c) { return c == ','; });
  for (std::string &part : parts)
    boost::algorithm::trim(part);
  return parts;
}

std::vector<std::string> split_at_bars(const std::string &list)
{
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list.compare(i, 2, "||") == 0)
    {
      parts.back() += "||";
      ++i;
    }
    else if (list[i] == '|')
      parts.emplace_back();
    else
      parts.back() += list[i];
  for (std::string &part : parts)
    part = dealii::Utilities::trim(part);
  return parts;
}

std::vector<std::pair<std::string, std::string>>
split_named_list(const std::string &list,
                 const std::string &parameter,
                 const bool of_vectors)
{
  using dealii::Utilities::trim;
  std::vector<std::pair<std::string, std::string>> elements;
  for (const std::string &element : split_elements(list, of_vectors))
  {
    const std::size_t colon = element.find(':');
    const std::string name = trim(element.substr(0, colon));
    const std::string value =
        colon == std::string::npos ? "" : trim(element.substr(colon + 1));
    if (name.empty() || value.empty())
      throw InputError("The parameter '" + parameter + "' has the element '" +
                       element +
                       "', which is not of the form \"name: value\".");
    elements.emplace_back(name, value);
  }
  return elements;
}
} // namespace Voussoir
