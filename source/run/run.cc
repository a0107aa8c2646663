// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/run/run.h>
#include <voussoir/run/unused_settings.h>
#include <voussoir/scene/loads/load_cases.h>

#include <deal.II/base/utilities.h>

#include <boost/algorithm/string/predicate.hpp>

#include <iostream>

namespace Voussoir
{
namespace
{
/** The load cases of the sources. */
std::set<std::string> load_cases_in(const std::vector<ParameterInput> &inputs,
                                    const ParameterSources &sources)
{
  std::set<std::string> cases;
  for (const ParameterInput &input : inputs)
    cases.merge(input.sections_in(load_cases_section));
  for (const std::string &text : sources.assignments)
  {
    const SectionPath section = assignment_of_text(text).to.section;
    if (section.size() > 1 && section[0] == load_cases_section)
      cases.insert(section[1]);
  }
  return cases;
}
} // namespace

std::vector<ParameterInput> ParameterSources::inputs() const
{
  std::vector<ParameterInput> inputs;
  if (file)
    inputs.emplace_back(*file);
  if (!text.empty())
    inputs.emplace_back(text, "the text");
  return inputs;
}

Run::Run(Terminal &terminal)
    : terminal(terminal), timer(std::cout,
                                dealii::TimerOutput::never,
                                dealii::TimerOutput::wall_times)
{}

void Run::read(const ParameterSources &sources)
{
  const std::vector<ParameterInput> inputs = sources.inputs();
  prm.declare_entry(dimension_entry, "2", dealii::Patterns::Integer(2, 3),
                    "2: the blocks are polygons in the plane. 3: they are "
                    "polyhedra in space, with parameters of their own, which "
                    "'voussoir --print-parameters --set Dimension=3' lists; "
                    "its states, load factors and ranges are found as in the "
                    "plane.");
  declare(load_cases_in(inputs, sources));
  assigned.watch(prm);
  for (const ParameterInput &input : inputs)
    if (input.assign_to(prm))
      assigned.forget_unchanged();
  for (const std::string &assignment : sources.assignments)
    assign_parameter(prm, assignment);
  check_dimension();
}

void Run::assign(const std::string &assignment)
{
  assign_parameter(prm, assignment);
  check_dimension();
}

void Run::check_dimension()
{
  const std::string own = std::to_string(dimension());
  const std::string value = prm.get(dimension_entry);
  if (prm.get_integer(dimension_entry) == dimension())
    return;
  prm.set(dimension_entry, own);
  throw InputError("'Dimension' is " + value +
                   ", and this scene has been made with " + own +
                   "; make another one for it.");
}

void Run::print(std::ostream &out,
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

void Run::warn_of_unused() const
{
  for (const std::string &warning : unused_settings(assigned))
    terminal.warning(warning);
}
} // namespace Voussoir
