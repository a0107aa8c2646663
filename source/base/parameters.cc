// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters.h>

#include <fstream>
#include <regex>
#include <sstream>

namespace Voussoir
{
namespace
{
/**
 * What deal.II's parser has to say about a bad entry, as one line: without the
 * angle brackets and line breaks that it is wrapped in.
 */
std::string one_line(const dealii::ExceptionBase &exception)
{
  std::ostringstream out;
  exception.print_info(out);
  std::string message = std::regex_replace(out.str(), std::regex("\\s+"), " ");
  message = std::regex_replace(message, std::regex("^ | $"), "");
  return std::regex_replace(message, std::regex("<([^<>]*)>"), "'$1'");
}

void parse(dealii::ParameterHandler &prm,
           std::istream &in,
           const std::string &name)
{
  try
  {
    prm.parse_input(in, name);
  }
  catch (const dealii::ExceptionBase &exception)
  {
    throw InputError(one_line(exception) + " " + how_to_list_parameters);
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
  parse(prm, in, file.string());
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
  parse(prm, in, "--set " + assignment);
}
} // namespace Voussoir
