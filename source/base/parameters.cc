// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameter_faults.h>
#include <voussoir/base/parameters.h>
#include <voussoir/base/text_file.h>

#include <deal.II/base/utilities.h>

#include <optional>
#include <sstream>

namespace Voussoir
{
namespace
{
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

void parse(dealii::ParameterHandler &prm, const ParameterText &text)
{
  std::istringstream in(text.lines);
  try
  {
    prm.parse_input(in, text.name);
  }
  catch (const dealii::ExceptionBase &fault)
  {
    throw InputError(explain_fault(prm, fault, text) + " " +
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
  std::set<std::string> names;
  for (const SectionOfText &found :
       sections_before(read_text_file(file).value_or("")))
    if (found.path.size() == 2 && found.path[0] == section)
      names.insert(found.path[1]);
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
  const std::optional<std::string> text = read_text_file(file);
  if (!text)
    throw InputError("The parameter file '" + file.string() +
                     "' cannot be read. Give the path of a .prm file, such as "
                     "prm/shear_wall.prm.");
  // deal.II would look for an included file in the working directory.
  std::istringstream in(*text);
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
  parse(prm, {*text, file.string(), true});
  return is_listing(*text);
}

bool read_parameters_text(dealii::ParameterHandler &prm,
                          const std::string &text,
                          const std::string &name)
{
  parse(prm, {text, name, true});
  return is_listing(text);
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
  parse(prm, {opening + "set " + name + " = " + assignment.substr(equals + 1) +
                  "\n" + closing,
              "--set " + assignment, false});
}
} // namespace Voussoir
