// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameter_input.h>
#include <voussoir/base/parameters.h>
#include <voussoir/run_parameters.h>
#include <voussoir/unused_settings.h>

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/predicate.hpp>

#include <iostream>
#include <set>

namespace Voussoir
{
RunParameters::RunParameters(Terminal &terminal, const Team &team)
    : team(team), timer(std::cout,
                        dealii::TimerOutput::never,
                        dealii::TimerOutput::wall_times),
      study(terminal, this->team, timer), writer(terminal, this->team, timer)
{}

void RunParameters::read(const ParameterSources &sources)
{
  std::vector<ParameterInput> inputs;
  if (sources.file)
    inputs.emplace_back(*sources.file);
  if (!sources.text.empty())
    inputs.emplace_back(sources.text, "the text");
  const std::string load_cases = "Load cases";
  std::set<std::string> cases;
  for (const ParameterInput &input : inputs)
    cases.merge(input.sections_in(load_cases));
  for (const std::string &text : sources.assignments)
  {
    const SectionPath section = assignment_of_text(text).section;
    if (section.size() > 1 && section[0] == load_cases)
      cases.insert(section[1]);
  }

  writer.add_entries(prm);
  study.add_entries(prm);
  study.add_sections(prm, cases);
  writer.add_sections(prm);
  assigned.watch(prm);
  for (const ParameterInput &input : inputs)
    if (input.assign_to(prm))
      assigned.forget_unchanged();
  for (const std::string &assignment : sources.assignments)
    assign_parameter(prm, assignment);
}

void RunParameters::assign(const std::string &assignment)
{
  assign_parameter(prm, assignment);
}

void RunParameters::print(std::ostream &out,
                          const std::string &section,
                          const ParameterFormat format,
                          const Detail detail)
{
  check_section(prm, dealii::Utilities::split_string_list(section, '/'),
                "--print-parameters=" + section);
  const auto is_wanted = [&](const std::string &path) {
    return (section.empty() || boost::starts_with(path, section + '/')) &&
           (detail == Detail::listing || assigned.contains(path));
  };
  print_parameters(out, prm, is_wanted, format, detail);
}

std::vector<std::string> RunParameters::unused() const
{
  return unused_settings(assigned);
}
} // namespace Voussoir
