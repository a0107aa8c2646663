// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/nearest_name.h>
#include <voussoir/base/parameter_tree.h>
#include <voussoir/base/parameters.h>
#include <voussoir/base/reference.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

namespace Voussoir
{
namespace
{
/** A value of the user's, not longer than a message can show. */
constexpr std::size_t longest_value = 80;

/** Remove @p start from the beginning of @p text; true if it was there. */
bool take(std::string &text, const std::string &start)
{
  const bool found = text.compare(0, start.size(), start) == 0;
  if (found)
    text.erase(0, start.size());
  return found;
}

/**
 * The part of @p text between @p begin, with which @p text starts, and the last
 * @p end, shortened; nothing if it is of another form. (Not by std::regex,
 * which takes a stack as deep as the text is long.)
 */
std::optional<std::string> between(const std::string &text,
                                   const std::string &begin,
                                   const std::string &end)
{
  const std::size_t last = text.rfind(end);
  if (text.compare(0, begin.size(), begin) != 0 || last == std::string::npos ||
      last < begin.size())
    return {};
  std::string found = text.substr(begin.size(), last - begin.size());
  if (found.size() > longest_value)
    found = found.substr(0, longest_value) + "...";
  return found;
}

/** Add the paths of the sections, or of the entries, in @p section. */
void add_paths(const nlohmann::ordered_json &section,
               const std::string &path,
               const bool of_sections,
               std::vector<std::string> &paths)
{
  if (!section.is_object())
    return;
  for (const auto &[name, node] : section.items())
  {
    if (is_entry(node) != of_sections)
      paths.push_back(path + name);
    if (!is_entry(node))
      add_paths(node, path + name + '/', of_sections, paths);
  }
}

/**
 * "; did you mean 'Friction/Strength'?", or ".": one beside it if @p place,
 * "--set Friction/Strenght=1", names its section. Of a name that exists, but
 * outside of the section in which it was sought, it says so.
 */
std::string did_you_mean(const dealii::ParameterHandler &prm,
                         const std::string &name,
                         const std::string &place,
                         const bool of_sections)
{
  std::vector<std::string> paths, beside;
  add_paths(tree_of(prm), "", of_sections, paths);
  if (std::find(paths.begin(), paths.end(), name) != paths.end())
    return ", but there is one outside of all sections.";
  for (const std::string &path : paths)
    if (place.find(' ' + path.substr(0, path.rfind('/') + 1) + name) !=
        std::string::npos)
      beside.push_back(path);
  if (!nearest_names(name, beside).empty())
    paths = beside;
  std::string names;
  for (const std::string &path : nearest_names(name, paths))
    names += (names.empty() ? "'" : " or '") + path + '\'';
  return names.empty() ? "." : "; did you mean " + names + '?';
}

/**
 * The message of deal.II's parser about a bad entry, in words that a user
 * knows, if it is one of the usual faults.
 */
std::string in_plain_words(const dealii::ParameterHandler &prm,
                           const std::string &message,
                           const std::string &where)
{
  const std::string named = " for the entry named ";
  const std::string pattern = " does not match the given pattern: ";
  const std::string begin = "The entry value";
  const bool is_empty =
      message.compare(0, begin.size() + named.size(), begin + named) == 0;
  if (const auto value =
          is_empty ? std::string() : between(message, begin + ' ', named))
  {
    const std::string rest = message.substr(message.rfind(named));
    const auto name = between(rest, named, pattern);
    return "'" + *name + "' is '" + *value + "', but must be " +
           text_of_pattern(rest.substr(rest.find('['))) + ".";
  }
  if (const auto name = between(message, "No entry with name <",
                                "> was declared in the current subsection"))
    return "there is no parameter '" + *name + "' in this section" +
           did_you_mean(prm, *name, where, false);
  if (const auto name =
          between(message, "There is no such subsection to be entered: ", "."))
    return "there is no section '" + *name + "' here" +
           did_you_mean(prm, *name, where, true);
  if (const auto line = between(message, "The line <", "> could not be parsed"))
    return "'" + *line +
           "' is neither 'set NAME = VALUE' nor 'subsection NAME' nor 'end'.";
  std::string other = message;
  std::replace(other.begin(), other.end(), '<', '\'');
  std::replace(other.begin(), other.end(), '>', '\'');
  return other;
}

/**
 * The message of deal.II's parser about a bad entry, as one sentence. It begins
 * with "Line <7> of file <name>:", which is of use for a file with several
 * lines only.
 */
std::string explain(const dealii::ParameterHandler &prm,
                    const dealii::ExceptionBase &exception,
                    const std::string &name,
                    const bool is_file)
{
  std::ostringstream out;
  exception.print_info(out);
  std::string message, word;
  for (std::istringstream words(out.str()); words >> word;)
    message += (message.empty() ? "" : " ") + word;

  std::string place = is_file ? "'" + name + "'" : name;
  if (take(message, "Line <"))
  {
    const std::string line = message.substr(0, message.find('>'));
    if (take(message, line + "> of file <" + name))
    {
      take(message, ">");
      take(message, ":");
      take(message, " ");
    }
    if (is_file)
      place = "Line " + line + " of " + place;
  }
  if (message.empty() || message.back() != '.')
    message += '.';
  return place + ": " + in_plain_words(prm, message, place);
}

/** True if a line of a text is listing_title(). */
bool is_listing(std::istream &in)
{
  const std::string title = listing_title();
  for (std::string line; std::getline(in, line);)
    if (line == title)
      return true;
  return false;
}

/** Read the text again from its beginning. */
void rewind(std::istream &in)
{
  in.clear();
  in.seekg(0);
}

void parse(dealii::ParameterHandler &prm,
           std::istream &in,
           const std::string &name,
           const bool is_file)
{
  try
  {
    prm.parse_input(in, name);
  }
  catch (const dealii::ExceptionBase &exception)
  {
    throw InputError(explain(prm, exception, name, is_file) + " " +
                     how_to_list_parameters);
  }
}

/** See with_uses(). */
class PatternWithUses : public dealii::Patterns::PatternBase
{
public:
  PatternWithUses(const PatternBase &accepted, const std::string &uses)
      : accepted(accepted.clone()), uses(uses)
  {}

  bool match(const std::string &value) const override
  {
    return accepted->match(value);
  }

  std::string description(const OutputStyle style) const override
  {
    return accepted->description(style) + (style == Machine ? uses : "");
  }

  std::unique_ptr<PatternBase> clone() const override
  {
    return std::make_unique<PatternWithUses>(*accepted, uses);
  }

private:
  const std::unique_ptr<PatternBase> accepted;
  const std::string uses;
};
} // namespace

std::unique_ptr<dealii::Patterns::PatternBase>
with_uses(const dealii::Patterns::PatternBase &accepted,
          const std::string &uses)
{
  return std::make_unique<PatternWithUses>(accepted, uses);
}

Uses uses_in(const std::string &description)
{
  using dealii::Utilities::split_string_list;
  Uses uses;
  for (const std::string &of_value :
       split_string_list(description.substr(description.rfind(']') + 1), ';'))
  {
    const auto value_and_names = split_string_list(of_value, ':');
    uses.emplace_back(value_and_names.at(0),
                      split_string_list(value_and_names.at(1), ','));
  }
  return uses;
}

const std::string how_to_list_parameters =
    "Run 'voussoir --print-parameters' to see every parameter and what it "
    "accepts.";

std::set<std::string>
subsections_in(const std::string &section,
               const std::filesystem::path &file,
               const std::vector<std::string> &assignments)
{
  using dealii::Utilities::trim;
  std::set<std::string> names;
  std::ifstream in(file);
  std::vector<std::string> path;
  for (std::string line; std::getline(in, line);)
  {
    line = trim(line.substr(0, line.find('#')));
    std::string word = line.substr(0, line.find_first_of(" \t"));
    if (word == "subsection" || word == "SUBSECTION")
    {
      path.push_back(trim(line.substr(word.size())));
      if (path.size() == 2 && path[0] == section)
        names.insert(path[1]);
    }
    else if ((line == "end" || line == "END") && !path.empty())
      path.pop_back();
  }
  for (const std::string &assignment : assignments)
  {
    const auto words = dealii::Utilities::split_string_list(
        assignment.substr(0, assignment.find('=')), '/');
    if (words.size() > 2 && words[0] == section)
      names.insert(words[1]);
  }
  return names;
}

std::string listing_title()
{
  std::stringstream listing;
  dealii::ParameterHandler().print_parameters(listing,
                                              dealii::ParameterHandler::PRM);
  std::string title;
  std::getline(listing, title);
  return title;
}

bool read_parameters(dealii::ParameterHandler &prm,
                     const std::filesystem::path &file)
{
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file))
    throw InputError("The parameter file '" + file.string() +
                     "' cannot be read. Give the path of a .prm file, such as "
                     "prm/shear_wall.prm.");
  // deal.II would look for an included file in the working directory.
  std::string line;
  for (unsigned int number = 1; std::getline(in, line); ++number)
  {
    std::istringstream words(line);
    std::string first;
    words >> first;
    if (first == "include" || first == "INCLUDE")
      throw InputError("Line " + std::to_string(number) + " of '" +
                       file.string() +
                       "' includes another file; give all parameters in one, "
                       "or on the command line with --set.");
  }
  rewind(in);
  parse(prm, in, file.string(), true);
  rewind(in);
  return is_listing(in);
}

bool read_parameters_text(dealii::ParameterHandler &prm,
                          const std::string &text,
                          const std::string &name)
{
  std::istringstream in(text);
  parse(prm, in, name, true);
  rewind(in);
  return is_listing(in);
}

void assign_parameter(dealii::ParameterHandler &prm,
                      const std::string &assignment)
{
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos)
    throw InputError("--set '" + assignment +
                     "' is not of the form \"Section/Name=value\".");

  std::string name = assignment.substr(0, equals), opening, closing;
  for (std::size_t slash; (slash = name.find('/')) != std::string::npos;)
  {
    opening += "subsection " + name.substr(0, slash) + "\n";
    closing += "end\n";
    name.erase(0, slash + 1);
  }
  std::istringstream in(opening + "set " + name + " = " +
                        assignment.substr(equals + 1) + "\n" + closing);
  parse(prm, in, "--set " + assignment, false);
}
} // namespace Voussoir
