// SPDX-License-Identifier: LGPL-2.1-or-later

// The words of a command line, one a line, with the ranges of sweeps in them.

#include <voussoir/base/parameters/parameters.h>
#include <voussoir/run/command_line/arguments.h>
#include <voussoir/run/sweep/sweep_values.h>

#include "harness.h"

namespace
{
const Fuzzing::Target of_arguments("arguments", [](const std::string &input) {
  using namespace Voussoir;
  const Arguments arguments = arguments_of(Fuzzing::lines_of(input));
  for (const std::string &text : arguments.sweeps)
  {
    const SweepAxis axis = read_sweep_axis(text);
    assignment_of_text(axis.of.assignment(axis.values.back()));
  }
  if (!arguments.find.empty())
    assignment_of_text(read_search_range(arguments.find).of.assignment("1"));
});
} // namespace
