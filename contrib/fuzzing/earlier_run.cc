// SPDX-License-Identifier: LGPL-2.1-or-later

// What an earlier run has written: summary.json, interfaces.csv, cells.csv and
// links.csv, with form feeds between, of the scene of seeds.py.

#include "harness.h"
#include <filesystem>

namespace
{
const Fuzzing::Target
    of_earlier_run("earlier_run", [](const std::string &input) {
      std::filesystem::create_directory("earlier");
      std::size_t begin = 0;
      for (const char *const name :
           {"summary.json", "interfaces.csv", "cells.csv", "links.csv"})
      {
        const std::size_t end = std::min(input.find('\f', begin), input.size());
        Fuzzing::write_file(std::string("earlier/") + name,
                            input.substr(begin, end - begin));
        begin = std::min(end + 1, input.size());
      }
      Fuzzing::with_run({"scene.prm"}, [](Voussoir::Run &run) {
        run.assign("Forces from=earlier");
        run.carry_out("", false);
      });
    });
} // namespace
