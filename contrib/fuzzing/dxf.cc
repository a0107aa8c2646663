// SPDX-License-Identifier: LGPL-2.1-or-later

// Drawings in DXF, by GDAL.

#include "harness.h"

namespace
{
const Fuzzing::Target of_dxf("dxf", [](const std::string &input) {
  static auto reader = Fuzzing::drawing("drawing.dxf");
  reader.read(input);
});
} // namespace
