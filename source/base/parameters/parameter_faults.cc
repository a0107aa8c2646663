// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameter_faults.h>
#include <voussoir/base/parameters/parameter_lines.h>
#include <voussoir/base/text.h>

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Utilities::trim;

/**
 * The part of @p text between @p begin, with which @p text starts, and the last
 * @p end; nothing if it is of another form. (Not by std::regex, which takes a
 * stack as deep as the text is long.)
 */
std::optional<std::string> between(const std::string &text,
                                   const std::string &begin,
                                   const std::string &end)
{
  const std::size_t last = text.rfind(end);
  if (!boost::starts_with(text, begin) || last == std::string::npos ||
      last < begin.size())
    return {};
  return text.substr(begin.size(), last - begin.size());
}

std::string on_one_line(const std::string &lines)
{
  std::string all, word;
  for (std::istringstream words(lines); words >> word;)
    all += (all.empty() ? "" : " ") + word;
  return all;
}

/** One fault of a text, and the line and the sections that it is in. */
class FaultOfText
{
public:
  FaultOfText(dealii::ParameterHandler &prm,
              const dealii::ExceptionBase &fault,
              const ParameterText &text)
      : prm(prm), text(text), place("'" + text.name + "'")
  {
    std::ostringstream out;
    fault.print_info(out);
    message = on_one_line(out.str());
    find_line();
    for (SectionOfText &section : sections_before(text.lines, line))
      if (section.is_open)
        open.push_back(std::move(section));
  }

  std::string explanation()
  {
    if (message.empty() || message.back() != '.')
      message += '.';
    return place + ": " + in_plain_words();
  }

private:
  /** Take "Line <7> of file <name>:", or without the last >, away. */
  void find_line()
  {
    const std::string begin = "Line <";
    if (!boost::starts_with(message, begin))
      return;
    const std::string number =
        message.substr(begin.size(), message.find('>') - begin.size());
    const std::string of_file =
        begin + number + "> of file <" + on_one_line(text.name);
    if (boost::starts_with(message, of_file))
      message = boost::trim_left_copy_if(message.substr(of_file.size()),
                                         boost::is_any_of(">: "));
    line = std::stoul(number);
    std::istringstream in(text.lines);
    for (unsigned int k = 0; k < line; ++k)
      std::getline(in, faulty);
    faulty = statement_of_line(faulty);
    place = "Line " + number + " of " + place;
  }

  std::string in_plain_words()
  {
    const std::string named = " for the entry named ";
    const std::string pattern = " does not match the given pattern: ";
    const std::string begin = "The entry value";
    // White space was joined: of an empty value nothing is left.
    const bool is_empty = boost::starts_with(message, begin + named);
    if (const auto value =
            is_empty ? std::string() : between(message, begin + ' ', named))
    {
      const std::string rest = message.substr(message.rfind(named));
      return assignment().unaccepted_value(*between(rest, named, pattern),
                                           *value, rest.substr(rest.find('[')));
    }
    if (const auto name = between(message, "No entry with name <",
                                  "> was declared in the current subsection"))
      return unknown_entry(*name);
    if (boost::starts_with(message,
                           "There is no such subsection to be entered") ||
        boost::contains(message, "does not know of any such subsection"))
      return unknown_section(trim(faulty.substr(first_word(faulty).size())));
    if (boost::starts_with(message, "There are unequal numbers of"))
      return missing_end();
    if (!faulty.empty())
      return faulty_statement();
    return boost::replace_all_copy(boost::replace_all_copy(message, "<", "'"),
                                   ">", "'");
  }

  /** One in the innermost open section. */
  FaultyAssignment assignment() const
  {
    return {prm, open.empty() ? SectionPath() : open.back().path};
  }

  /** ", which begins in line 3, but ...", if it is in a section around. */
  std::optional<std::string> in_section_around(const std::string &name,
                                               const bool is_section) const
  {
    const std::vector<std::string> all = assignment().paths(is_section);
    SectionPath section = open.empty() ? SectionPath() : open.back().path;
    while (!section.empty())
    {
      section.pop_back();
      const std::string around = text_of_section(section);
      if (std::find(all.begin(), all.end(), around + name) != all.end())
        return Voussoir::text(
            '\'', name, "' is not in the section '", open.back().path.back(),
            "', which begins in line ", open.back().line, ", but ",
            around.empty() ? "outside of all sections"
                           : "in '" + around.substr(0, around.size() - 1) + "'",
            "; add the 'end' that is missing before, or move it there.");
    }
    return {};
  }

  std::string unknown_entry(const std::string &name) const
  {
    if (const auto fault = in_section_around(name, false))
      return *fault;
    return assignment().unknown_entry(name);
  }

  std::string unknown_section(const std::string &name) const
  {
    if (const auto fault = in_section_around(name, true))
      return *fault;
    return assignment().unknown_section(name);
  }

  std::string missing_end() const
  {
    std::string sections;
    for (const SectionOfText &section : open)
      sections +=
          Voussoir::text(sections.empty() ? "" : " and of ", '\'',
                         section.path.back(), "' in line ", section.line);
    return "an 'end' is missing, of the section " + sections +
           " or of one inside; add it.";
  }

  /** "Width = 4" of "Width 4", if there is such an entry in this section. */
  std::optional<std::string> assignment_of(const std::string &words) const
  {
    const std::string section =
        open.empty() ? "" : text_of_section(open.back().path);
    std::string longest;
    for (const std::string &path : assignment().paths(false))
      if (boost::starts_with(path, section))
      {
        const std::string name = path.substr(section.size());
        if (name.size() > longest.size() &&
            boost::starts_with(words, name + ' '))
          longest = name;
      }
    if (longest.empty())
      return {};
    return shortened(longest + " = " + trim(words.substr(longest.size())));
  }

  std::string faulty_statement() const
  {
    const std::string quoted = "'" + shortened(faulty) + "' ";
    const std::string first = first_word(faulty);
    if (first == "set" || first == "SET")
      return quoted + "has no '='; write 'set " +
             assignment_of(trim(faulty.substr(first.size())))
                 .value_or("NAME = VALUE") +
             "'.";
    if (first == "end" || first == "END")
      return open.empty() ? quoted + "is one too many, here or before: there "
                                     "is no section to end; delete it."
                          : quoted + "must be 'end' alone; write what follows "
                                     "behind a #.";
    const std::size_t equals = faulty.find('=');
    if (equals != std::string::npos && !boost::iequals(first, "set"))
      return quoted + "does not begin with 'set'; write 'set " +
             shortened(trim(faulty.substr(0, equals)) + " = " +
                       trim(faulty.substr(equals + 1))) +
             "'.";
    if (const auto assignment = assignment_of(faulty))
      return quoted + "has neither 'set' nor '='; write 'set " + *assignment +
             "'.";
    return quoted +
           "is neither 'set NAME = VALUE' nor 'subsection NAME' nor 'end'.";
  }

  dealii::ParameterHandler &prm;
  const ParameterText &text;
  std::string place, message;
  unsigned int line = std::numeric_limits<unsigned int>::max();
  /** What stands in that line. */
  std::string faulty;
  std::vector<SectionOfText> open;
};
} // namespace

std::vector<SectionOfText> sections_before(const std::string &text,
                                           const unsigned int line)
{
  std::vector<SectionOfText> found;
  std::vector<std::size_t> open;
  for_each_line(text,
                [&](const SectionPath &sections, const std::string &content,
                    const unsigned int number) {
                  if (number >= line)
                    return;
                  if (const auto name = section_begun_by(content))
                  {
                    open.push_back(found.size());
                    found.push_back({sections, number, true});
                    found.back().path.push_back(*name);
                  }
                  else if (ends_section(content) && !open.empty())
                  {
                    found[open.back()].is_open = false;
                    open.pop_back();
                  }
                });
  return found;
}

std::string explain_fault(dealii::ParameterHandler &prm,
                          const dealii::ExceptionBase &fault,
                          const ParameterText &text)
{
  return FaultOfText(prm, fault, text).explanation();
}
} // namespace Voussoir
