// SPDX-License-Identifier: LGPL-2.1-or-later

// The program of a folder of tests: it runs the one that VOUSSOIR_TEST names.

#include "room.h"

#include <voussoir/base/blas.h>
#include <voussoir/base/memory.h>

#include <cstdlib>
#include <iostream>

int main()
{
  // As the program does.
  Voussoir::keep_memory();
  Voussoir::prepare_blas();
  const char *const name = std::getenv("VOUSSOIR_TEST");
  const auto found = RoomTest::all().find(name ? name : "");
  if (found == RoomTest::all().end())
  {
    std::cerr << "Set VOUSSOIR_TEST to the test to run, one of:";
    for (const auto &[known, run] : RoomTest::all())
      std::cerr << ' ' << known;
    std::cerr << std::endl;
    return 1;
  }
  found->second();
}
