// SPDX-License-Identifier: LGPL-2.1-or-later

// Points in space, of which Voronoi cells are made.

#include <voussoir/packing/polyhedra/voronoi/voronoi.h>

#include "harness.h"

namespace
{
const Fuzzing::Target
    of_space_points("space_points", [](const std::string &input) {
      static Fuzzing::FileReader<3, Voussoir::SpaceVoronoiGenerator> reader(
          "set Points = file\nset Points file = points.txt", "points.txt");
      reader.read(input);
    });
} // namespace
