// SPDX-License-Identifier: LGPL-2.1-or-later

// Drawings in OFF.

#include "harness.h"

namespace
{
const Fuzzing::Target of_plane_off("plane_off", [](const std::string &input) {
  static auto reader = Fuzzing::drawing("drawing.off");
  reader.read(input);
});
} // namespace
