// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks in OFF.

#include "harness.h"

namespace
{
const Fuzzing::Target of_off("off", [](const std::string &input) {
  static auto reader = Fuzzing::model("model.off");
  reader.read(input);
});
} // namespace
