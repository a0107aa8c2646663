// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters.h>
#include <voussoir/run_parameters.h>
#include <voussoir/unused_settings.h>

#include <iostream>

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
  writer.add_entries(prm);
  study.add_entries(prm);
  study.add_sections(prm,
                     subsections_in("Load cases", sources.file.value_or(""),
                                    sources.assignments));
  writer.add_sections(prm);
  assigned.watch(prm);
  if (sources.file && read_parameters(prm, *sources.file))
    assigned.forget_unchanged();
  if (!sources.text.empty() &&
      read_parameters_text(prm, sources.text, "the text"))
    assigned.forget_unchanged();
  for (const std::string &assignment : sources.assignments)
    assign_parameter(prm, assignment);
}

void RunParameters::assign(const std::string &assignment)
{
  assign_parameter(prm, assignment);
}

std::vector<std::string> RunParameters::unused() const
{
  return unused_settings(assigned);
}
} // namespace Voussoir
