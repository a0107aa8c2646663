// SPDX-License-Identifier: LGPL-2.1-or-later

// Runs of tiny scenes to their end, without files.

#include <voussoir/base/exceptions.h>

#include "harness.h"

namespace
{
const Fuzzing::Target of_run("run", [](const std::string &input) {
  Fuzzing::with_run({{}, input}, [](Voussoir::Run &run) {
    try
    {
      run.carry_out("", false);
    }
    catch (const Voussoir::SolverError &error)
    {
      Fuzzing::check_message(error.what());
    }
  });
});
} // namespace
