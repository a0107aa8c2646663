// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters.h>
#include <voussoir/base/reference.h>

#include <fstream>
#include <regex>
#include <sstream>

namespace Voussoir
{
namespace
{
/** Whether @p text begins with @p start; then remove it. */
bool take(std::string &text, const std::string &start)
{
  const bool found = text.compare(0, start.size(), start) == 0;
  if (found)
    text.erase(0, start.size());
  return found;
}

/**
 * What deal.II's parser has to say about a bad entry, as one sentence: without
 * its line breaks and angle brackets. It begins with "Line <7> of file
 * <name>:", which is of use for a file with several lines only.
 */
std::string explain(const dealii::ExceptionBase &exception,
                    const std::string &name,
                    const bool is_file)
{
  std::ostringstream out;
  exception.print_info(out);
  std::string message = std::regex_replace(out.str(), std::regex("\\s+"), " ");
  message = std::regex_replace(message, std::regex("^ | $"), "");

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
  std::smatch found;
  const auto is = [&](const char *pattern) {
    return std::regex_match(message, found, std::regex(pattern));
  };
  if (is("The entry value (.*) for the entry named (.*) does not match the "
         "given pattern: (\\[.*\\])\\.?"))
    return place + ": '" + found[2].str() + "' is '" + found[1].str() +
           "', but must be " + text_of_pattern(found[3]) + ".";
  if (is("No entry with name <(.*)> was declared in the current subsection\\."))
    return place + ": there is no parameter '" + found[1].str() +
           "' in this section.";
  if (is("There is no such subsection to be entered: (.*?)\\.?"))
    return place + ": there is no section '" + found[1].str() + "' here.";
  if (is("The line <(.*)> could not be parsed: .*"))
    return place + ": '" + found[1].str() +
           "' is neither 'set NAME = VALUE' nor 'subsection NAME' nor 'end'.";
  message = std::regex_replace(message, std::regex("<([^<>]*)>"), "'$1'");
  if (message.back() != '.')
    message += '.';
  return place + ": " + message;
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
    throw InputError(explain(exception, name, is_file) + " " +
                     how_to_list_parameters);
  }
}
} // namespace

const std::string how_to_list_parameters =
    "Run 'voussoir --print-parameters' to see every parameter and what it "
    "accepts.";

void read_parameters(dealii::ParameterHandler &prm,
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
    if (std::regex_search(line, std::regex("^\\s*(include|INCLUDE)\\s")))
      throw InputError("Line " + std::to_string(number) + " of '" +
                       file.string() +
                       "' includes another file; give all parameters in one, "
                       "or on the command line with --set.");
  in.clear();
  in.seekg(0);
  parse(prm, in, file.string(), true);
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
