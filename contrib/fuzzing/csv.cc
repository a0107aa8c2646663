// SPDX-License-Identifier: LGPL-2.1-or-later

// Drawings in CSV, by GDAL.

#include "harness.h"

namespace
{
const Fuzzing::Target of_csv("csv", [](const std::string &input) {
  static auto reader = Fuzzing::drawing("drawing.csv");
  reader.read(input);
});
} // namespace
