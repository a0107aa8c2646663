// SPDX-License-Identifier: LGPL-2.1-or-later

// Assignments of --set, one a line, to a wall of two bricks, up to the solver.

#include "harness.h"

namespace
{
const char *const wall = "subsection Packing\n"
                         "set Generator = wall\n"
                         "subsection wall\n"
                         "set Courses = 2\n"
                         "set Bricks per course = 1\n"
                         "end\n"
                         "end\n"
                         "subsection Supports\n"
                         "set Where = y < 1e-9\n"
                         "end\n";

const Fuzzing::Target of_settings("settings", [](const std::string &input) {
  Fuzzing::validate({{}, wall, Fuzzing::lines_of(input)});
});
} // namespace
