// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameter_tree.h>
#include <voussoir/base/reference.h>
#include <voussoir/base/text.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <ostream>
#include <regex>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** The width of a line, as on the other pages. */
constexpr unsigned int line_width = 90;

/** "a number from LOW to HIGH", without the bounds that are none. */
std::string text_of_range(const std::string &number,
                          const std::string &low,
                          const std::string &high)
{
  const bool from_below = low == "-MAX_DOUBLE" || low == "-2147483648";
  const bool to_above = high == "MAX_DOUBLE" || high == "2147483647";
  if (from_below && to_above)
    return number;
  if (to_above)
    return number + ", at least " + low;
  if (from_below)
    return number + ", at most " + high;
  return number + " from " + low + " to " + high;
}

std::string quoted(std::string names)
{
  boost::algorithm::replace_all(names, "|", "', '");
  return "'" + names + "'";
}

/** The text as a paragraph of Markdown, with its marks escaped. */
std::string escaped(std::string words)
{
  for (const char *mark : {"*", "<"})
    boost::algorithm::replace_all(words, mark, std::string("\\") + mark);
  return words;
}

void write_paragraph(std::ostream &out,
                     const std::string &words,
                     const std::string &indent)
{
  const auto lines = dealii::Utilities::break_text_into_lines(
      words, line_width - indent.size());
  out << boost::algorithm::join(lines, "\n" + indent) << '\n';
}

/** The entries of a section, and then the sections in it. */
void write_section(std::ostream &out,
                   const Json &section,
                   const std::string &path)
{
  if (!section.is_object()) // boost writes a section without entries as ""
    return;
  out << "\n## " << (path.empty() ? "Top level" : path) << "\n\n";
  for (const auto &[name, node] : section.items())
    if (is_entry(node))
    {
      const std::string fallback = node["default_value"];
      out << "- **" << name << "**, by default "
          << (fallback.empty() ? "empty" : "`" + fallback + "`") << ": "
          << escaped(text_of_pattern(node["pattern_description"])) << ".\n  ";
      write_paragraph(out, escaped(node["documentation"]), "  ");
    }
  for (const auto &[name, node] : section.items())
    if (!is_entry(node))
      write_section(out, node, path.empty() ? name : path + "/" + name);
}
} // namespace

std::string text_of_pattern(const std::string &text)
{
  const std::string description = text.substr(0, text.rfind(']') + 1);
  std::smatch found;
  const auto is = [&](const char *pattern) {
    return std::regex_match(description, found, std::regex(pattern));
  };
  if (is("\\[Anything\\]"))
    return "any text";
  if (is("\\[Bool\\]"))
    return "true or false";
  if (is("\\[Double (\\S+)\\.\\.\\.(\\S+) \\(inclusive\\)\\]"))
    return text_of_range("a number", found[1], found[2]);
  if (is("\\[Integer range (\\S+)\\.\\.\\.(\\S+) \\(inclusive\\)\\]"))
    return text_of_range("a whole number", found[1], found[2]);
  if (is("\\[Selection (.*?) ?\\]"))
    return "one of " + quoted(found[1]);
  if (is("\\[List of <(.*)> of length (\\d+)\\.\\.\\.(\\d+) \\(inclusive\\)"
         "(?: separated by <(.*)>)?\\]"))
  {
    const std::string separator = found[4].matched ? found[4].str() : ",";
    const std::string low = found[2], high = found[3];
    std::string values = "values";
    if (low == high)
      values = low + " values";
    else if (high != "2147483647" && high != "4294967295")
      values = low + " to " + high + " values";
    else if (low != "0")
      values = "at least " + low + " values";
    const std::string element = text_of_pattern(found[1]);
    return values + " separated by '" + separator + "'" +
           (element == "any text" ? "" : ", each " + element);
  }
  return description;
}

void write_reference(std::ostream &out, const dealii::ParameterHandler &prm)
{
  out << "# Parameters\n\n";
  write_paragraph(
      out,
      "Every entry of a .prm file, by section, with its default and what it "
      "accepts. `voussoir --print-reference` has written this page, and "
      "`voussoir --print-parameters` prints the same as a .prm file. What a "
      "file leaves out keeps its default. On the command line an entry is "
      "assigned by its path, as in `--set \"Solver/Tolerance=1e-8\"`.",
      "");
  write_section(out, tree_of(prm), "");
}
} // namespace Voussoir
