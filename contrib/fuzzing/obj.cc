// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks in OBJ.

#include "harness.h"

namespace
{
const Fuzzing::Target of_obj("obj", [](const std::string &input) {
  static auto reader = Fuzzing::model("model.obj");
  reader.read(input);
});
} // namespace
