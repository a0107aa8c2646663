// SPDX-License-Identifier: LGPL-2.1-or-later

// Blocks in Neper's tessellations.

#include "harness.h"

namespace
{
const Fuzzing::Target of_tess("tess", [](const std::string &input) {
  static auto reader = Fuzzing::model("model.tess");
  reader.read(input);
});
} // namespace
