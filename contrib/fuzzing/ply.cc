// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks in PLY.

#include "harness.h"

namespace
{
const Fuzzing::Target of_ply("ply", [](const std::string &input) {
  static auto reader = Fuzzing::model("model.ply");
  reader.read(input);
});
} // namespace
