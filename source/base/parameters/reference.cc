// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameter_tree.h>
#include <voussoir/base/parameters/pattern_description.h>
#include <voussoir/base/parameters/reference.h>
#include <voussoir/base/text.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <ostream>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** The width of a line, as on the other pages. */
constexpr unsigned int line_width = 90;

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

void write_reference(std::ostream &out,
                     const dealii::ParameterHandler &prm,
                     const std::string &title,
                     const std::string &options)
{
  out << "# " << title << "\n\n";
  write_paragraph(
      out,
      "Every entry of a .prm file, by section, with its default and what it "
      "accepts. `voussoir --print-reference" +
          options +
          "` has written this page, and `voussoir --print-parameters" +
          options +
          "` prints the same as a .prm file. What a "
          "file leaves out keeps its default. On the command line an entry is "
          "assigned by its path, as in `--set \"Solver/Tolerance=1e-8\"`.",
      "");
  write_section(out, tree_of(prm), "");
}
} // namespace Voussoir
