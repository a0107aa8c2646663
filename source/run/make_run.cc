// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/run/analysis_run.h>
#include <voussoir/run/make_run.h>
#include <voussoir/run/space_run.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <string>

namespace Voussoir
{
unsigned int dimension_of(const ParameterSources &sources)
{
  std::string value;
  for (const ParameterInput &input : sources.inputs())
    for (const auto &[entry, of_entry] : input.entries_in(""))
      if (entry == dimension_entry)
        value = of_entry;
  for (const std::string &text : sources.assignments)
  {
    const Assignment assignment = assignment_of_text(text);
    if (assignment.to.section.empty() && assignment.to.entry == dimension_entry)
      value = assignment.value;
  }
  int number; // as the entry reads it: "03", too
  return boost::conversion::try_lexical_convert(value, number) && number == 3
             ? 3
             : 2;
}

std::unique_ptr<Run> make_run(const ParameterSources &sources,
                              Terminal &terminal,
                              const ProcessGroup &processes)
{
  std::unique_ptr<Run> run;
  if (dimension_of(sources) == 3)
    run = std::make_unique<SpaceRun>(terminal, processes);
  else
    run = std::make_unique<AnalysisRun>(terminal, processes);
  run->read(sources);
  return run;
}
} // namespace Voussoir
