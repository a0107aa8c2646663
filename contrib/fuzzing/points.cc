// SPDX-License-Identifier: LGPL-2.1-or-later

// Points in the plane, of which Voronoi cells are made.

#include <voussoir/packing/voronoi/voronoi.h>

#include "harness.h"

namespace
{
const Fuzzing::Target of_points("points", [](const std::string &input) {
  static Fuzzing::FileReader<2, Voussoir::VoronoiGenerator> reader(
      "set Points = file\nset Points file = points.txt", "points.txt");
  reader.read(input);
});
} // namespace
