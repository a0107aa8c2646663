// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks in STL.

#include "harness.h"

namespace
{
const Fuzzing::Target of_stl("stl", [](const std::string &input) {
  static auto reader = Fuzzing::model("model.stl");
  reader.read(input);
});
} // namespace
