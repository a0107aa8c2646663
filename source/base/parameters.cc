// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters.h>

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
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw InputError("--set '" + text +
                     "' is not of the form \"Section/Name=value\".");
  Assignment assignment;
  assignment.section =
      dealii::Utilities::split_string_list(text.substr(0, equals), '/');
  if (assignment.section.empty())
    assignment.section.emplace_back();
  assignment.entry = assignment.section.back();
  assignment.section.pop_back();
  assignment.value = text.substr(equals + 1);
  return assignment;
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
  const SectionPath &section = assignment.section;
  check_section(prm, section, place);
  const std::string value = dealii::Utilities::trim(assignment.value);
  for (const std::string &name : section)
    prm.enter_subsection(name);
  bool is_declared = true, is_accepted = true;
  try
  {
    prm.set(assignment.entry, value);
  }
  catch (const dealii::ParameterHandler::ExcEntryUndeclared &)
  {
    is_declared = false;
  }
  catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
  {
    is_accepted = false;
  }
  for (unsigned int k = 0; k < section.size(); ++k)
    prm.leave_subsection();
  if (is_declared && is_accepted)
    return;
  const FaultyAssignment faulty(prm, section);
  throw InputError(place + ": " +
                   (is_declared
                        ? faulty.unaccepted_value(assignment.entry, value)
                        : faulty.unknown_entry(assignment.entry)) +
                   ' ' + how_to_list_parameters);
}

void assign_parameter(dealii::ParameterHandler &prm,
                      const std::string &assignment)
{
  assign(prm, assignment_of_text(assignment), "--set " + assignment);
}
} // namespace Voussoir
