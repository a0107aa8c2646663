// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/faulty_assignment.h>
#include <voussoir/base/parameters/nested_parameters.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>

#include <boost/algorithm/hex.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <sstream>
#include <utility>

namespace Voussoir
{
namespace
{
using Nested = boost::property_tree::ptree;

/** Far more than there are sections in sections. */
constexpr unsigned int most_levels = 100;

/** Behind a string of JSON that begins at @p k. */
std::size_t behind_string(const std::string &text, std::size_t k)
{
  for (++k; k < text.size() && text[k] != '"'; ++k)
    k += text[k] == '\\';
  return std::min(k + 1, text.size());
}

/** True if braces are deeper in one another than that. */
bool is_too_deep_json(const std::string &text)
{
  unsigned int depth = 0;
  for (std::size_t k = 0; k < text.size();)
  {
    if (text[k] == '"') // braces in it need not be in pairs
    {
      k = behind_string(text, k);
      continue;
    }
    if ((text[k] == '{' || text[k] == '[') && ++depth > most_levels)
      return true;
    if ((text[k] == '}' || text[k] == ']') && depth > 0)
      --depth;
    ++k;
  }
  return false;
}

/** Behind the next @p end from @p k on. */
std::size_t
behind(const std::string &text, const std::string &end, const std::size_t k)
{
  const std::size_t begin = text.find(end, k);
  return begin == text.npos ? text.size() : begin + end.size();
}

/** The end of the tag that begins at @p k, or what is no tag in its place. */
std::size_t end_of_tag(const std::string &text, std::size_t k)
{
  // The names that boost's reader accepts, since more or less would be a way to
  // hide a level.
  const char *const blanks = " \t\r\n";
  const auto skip_to = [&](const std::size_t to) {
    k = std::min(to, text.size());
    return k < text.size() ? text[k] : '>';
  };
  const auto skip_blanks = [&] {
    return skip_to(text.find_first_not_of(blanks, k));
  };
  skip_to(text.find_first_of(" \t\r\n/>?", k));
  while (std::strchr("/<>=?!", skip_blanks()) == nullptr)
  {
    skip_to(text.find_first_of(" \t\r\n/<>=?!", k));
    if (skip_blanks() != '=')
      break;
    ++k;
    const char quote = skip_blanks();
    if (quote != '"' && quote != '\'')
      break;
    skip_to(behind(text, std::string(1, quote), k + 1));
  }
  return k;
}

/** Behind the declaration of a type that begins at @p k. */
std::size_t behind_type(const std::string &text, std::size_t k)
{
  for (unsigned int n_open = 0;
       k < text.size() && (text[k] != '>' || n_open > 0); ++k)
    n_open += (text[k] == '[') - (text[k] == ']' && n_open > 0);
  return k;
}

/** True if elements are deeper in one another than that. */
bool is_too_deep_xml(const std::string &text)
{
  unsigned int depth = 0;
  for (std::size_t k = 0; (k = text.find('<', k)) < text.size();)
  {
    const auto begins = [&](const std::string &with) {
      return text.compare(k, with.size(), with) == 0;
    };
    if (begins("<!--"))
      k = behind(text, "-->", k + 4);
    else if (begins("<![CDATA["))
      k = behind(text, "]]>", k);
    else if (begins("<!DOCTYPE"))
      k = behind_type(text, k);
    else if (begins("<!"))
      k = behind(text, ">", k);
    else if (begins("<?"))
      k = behind(text, "?>", k);
    else if (begins("</"))
    {
      depth -= depth > 0;
      ++k;
    }
    else
    {
      k = end_of_tag(text, k + 1);
      if (begins(">") && ++depth > most_levels)
        return true;
      if (!begins(">") && !begins("/>"))
        return false; // the reader refuses it
    }
  }
  return false;
}

/** What @p parse makes of a text. */
template <typename Parse>
Nested parsed(const std::string &text,
              const std::string &file,
              const std::string &format,
              const Parse &parse)
{
  // For more levels boost's readers would call themselves.
  if (format == "XML" ? is_too_deep_xml(text) : is_too_deep_json(text))
    throw InputError("The file '" + file + "' has more than " +
                     std::to_string(most_levels) +
                     " levels of sections in sections; remove the innermost.");
  try
  {
    Nested nested;
    std::istringstream in(text);
    parse(in, nested);
    return nested;
  }
  catch (const boost::property_tree::file_parser_error &fault)
  {
    throw InputError(Voussoir::text(
        "Line ", fault.line(), " of '", file, "' is not valid ", format, ": ",
        fault.message(), "; change it there or before."));
  }
}

/** "Joint width" of "Joint_20width". */
std::string name_of_element(const std::string &element)
{
  std::string name;
  for (std::size_t k = 0; k < element.size(); ++k)
    if (element[k] == '_' && k + 2 < element.size() &&
        std::isxdigit(static_cast<unsigned char>(element[k + 1])) != 0 &&
        std::isxdigit(static_cast<unsigned char>(element[k + 2])) != 0)
    {
      name += boost::algorithm::unhex(element.substr(k + 1, 2));
      k += 2;
    }
    else
      name += element[k];
  return name;
}

Nested with_names_of_elements(const Nested &elements)
{
  Nested named(elements.data());
  for (const auto &[element, inner] : elements)
    if (element != "<xmlattr>")
      named.push_back(
          {name_of_element(element), with_names_of_elements(inner)});
  return named;
}

/** A walk through what is assigned. */
class Assigner
{
public:
  Assigner(dealii::ParameterHandler &prm, std::string place)
      : prm(prm), place(std::move(place))
  {}

  void assign_all(const Nested &section)
  {
    for (const auto &[name, node] : section)
    {
      path.push_back(name);
      if (prm.subsection_path_exists(path))
        enter(node);
      else
        assign_one(node);
      path.pop_back();
    }
  }

  bool is_listing() const { return documents; }

private:
  void enter(const Nested &section)
  {
    if (!section.data().empty())
      throw InputError(where() +
                       ": a section must have entries, and has the "
                       "value '" +
                       shortened(section.data()) + "'. " +
                       how_to_list_parameters);
    assign_all(section);
  }

  void assign_one(const Nested &node)
  {
    const auto value = node.find("value");
    documents = documents || node.count("default_value") > 0;
    const SectionPath section(path.begin(), path.end() - 1);
    if (value != node.not_found())
      assign(prm, {{section, path.back()}, value->second.data()}, where());
    else if (node.empty())
      assign(prm, {{section, path.back()}, node.data()}, where());
    else if (node.front().first.empty())
      throw InputError(where() + ": a value is one text, as in a .prm file; "
                                 "write the list as that.");
    else
      check_section(prm, path, where());
  }

  std::string where() const
  {
    const std::string with_slash = text_of_section(path);
    return place + ", '" + with_slash.substr(0, with_slash.size() - 1) + "'";
  }

  dealii::ParameterHandler &prm;
  const std::string place;
  SectionPath path;
  bool documents = false;
};
} // namespace

Nested nested_from_json(const std::string &text, const std::string &file)
{
  Nested nested =
      parsed(text, file, "JSON",
             [](std::istream &in, Nested &nested) { read_json(in, nested); });
  if (!nested.data().empty())
    throw InputError("The file '" + file +
                     "' has a single value; write sections and entries in "
                     "braces.");
  nested.erase("$schema"); // for editors
  return nested;
}

Nested nested_from_xml(const std::string &text, const std::string &file)
{
  const Nested root =
      parsed(text, file, "XML", [](std::istream &in, Nested &nested) {
        using namespace boost::property_tree::xml_parser;
        read_xml(in, nested, no_comments | trim_whitespace);
      });
  if (root.size() != 1 || root.front().first != "ParameterHandler")
    throw InputError("The outermost element of '" + file +
                     "' must be 'ParameterHandler'.");
  return with_names_of_elements(root.front().second);
}

bool assign_nested(dealii::ParameterHandler &prm,
                   const Nested &nested,
                   const std::string &place)
{
  Assigner assigner(prm, place);
  assigner.assign_all(nested);
  return assigner.is_listing();
}
} // namespace Voussoir
