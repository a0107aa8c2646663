// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_parameters_parameter_lines_h
#define voussoir_base_parameters_parameter_lines_h

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/predicate.hpp>

#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace Voussoir
{
/** The words of a line of a .prm file without a comment and white space around
 * them. */
inline std::string statement_of_line(const std::string &line)
{
  return dealii::Utilities::trim(line.substr(0, line.find('#')));
}

/** The first of words. */
inline std::string first_word(const std::string &words)
{
  return words.substr(0, words.find_first_of(" \t"));
}

/** The name of the section that a line begins, if it begins one. */
inline std::optional<std::string> section_begun_by(const std::string &line)
{
  const std::string statement = statement_of_line(line);
  const std::string first = first_word(statement);
  if (!boost::iequals(first, "subsection"))
    return {};
  return dealii::Utilities::trim(statement.substr(first.size()));
}

/** True if a line ends a section. */
inline bool ends_section(const std::string &line)
{
  return boost::iequals(statement_of_line(line), "end");
}

/**
 * Call a function for each line of a .prm file, valid or not.
 *
 * @param f takes the names of the sections that the line is in, the line, and
 *   its number from one; `subsection` and `end` are outside of their section.
 */
template <typename F>
void for_each_line(const std::string &lines, const F &f)
{
  std::istringstream in(lines);
  std::vector<std::string> sections;
  std::string line;
  for (unsigned int number = 1; std::getline(in, line); ++number)
  {
    if (ends_section(line) && !sections.empty())
      sections.pop_back();
    f(sections, line, number);
    if (const auto begun = section_begun_by(line))
      sections.push_back(*begun);
  }
}
} // namespace Voussoir

#endif
