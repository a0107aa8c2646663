// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks in COMPAS's JSON.

#include "harness.h"

namespace
{
const Fuzzing::Target of_compas("compas", [](const std::string &input) {
  static auto reader = Fuzzing::model("model.json");
  reader.read(input);
});
} // namespace
