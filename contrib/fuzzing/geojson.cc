// SPDX-License-Identifier: LGPL-2.1-or-later

// Drawings in GeoJSON, by GDAL.

#include "harness.h"

namespace
{
const Fuzzing::Target of_geojson("geojson", [](const std::string &input) {
  static auto reader = Fuzzing::drawing("drawing.geojson");
  reader.read(input);
});
} // namespace
