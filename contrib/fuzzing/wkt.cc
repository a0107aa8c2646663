// SPDX-License-Identifier: LGPL-2.1-or-later

// Drawings in well-known text.

#include "harness.h"

namespace
{
const Fuzzing::Target of_wkt("wkt", [](const std::string &input) {
  static auto reader = Fuzzing::drawing("drawing.wkt");
  reader.read(input);
});
} // namespace
