// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/faulty_assignment.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/printable.h>

#include <deal.II/base/utilities.h>

namespace Voussoir
{
namespace
{
/** A pattern with the uses of its values; see with_uses(). */
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

Assignment assignment_of_text(const std::string &text)
{
  if (!is_utf8(text))
    throw InputError("--set '" + text +
                     "' is not UTF-8 text; set the terminal to UTF-8, or use "
                     "a file of parameters.");
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw InputError("--set '" + text +
                     "' is not of the form \"Section/Name=value\".");
  return {entry_path_of(text.substr(0, equals)), text.substr(equals + 1)};
}

void check_section(dealii::ParameterHandler &prm,
                   const SectionPath &section,
                   const std::string &place)
{
  SectionPath around;
  for (const std::string &name : section)
  {
    around.push_back(name);
    if (prm.subsection_path_exists(around))
      continue;
    around.pop_back();
    throw InputError(place + ": " +
                     FaultyAssignment(prm, around).unknown_section(name) + ' ' +
                     how_to_list_parameters);
  }
}

void assign(dealii::ParameterHandler &prm,
            const Assignment &assignment,
            const std::string &place)
{
  const auto &[section, entry] = assignment.to;
  check_section(prm, section, place);
  const std::string value = dealii::Utilities::trim(assignment.value);
  std::string fault;
  try
  {
    const InSection in_section(prm, section);
    prm.set(entry, value);
    return;
  }
  catch (const dealii::ParameterHandler::ExcEntryUndeclared &)
  {
    fault = FaultyAssignment(prm, section).unknown_entry(entry);
  }
  catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
  {
    fault = FaultyAssignment(prm, section).unaccepted_value(entry, value);
  }
  throw InputError(place + ": " + fault + ' ' + how_to_list_parameters);
}
} // namespace Voussoir
