// SPDX-License-Identifier: LGPL-2.1-or-later

// A drawing with ten kinds of faults, three of each: one run names all thirty,
// with the stones that float and the gaps beside, and drawing_check.vtu has
// them; earlier results stay. Gaps that a run leaves open are named and shown.
// The nearest cells, and gaps, are found again by looking at all pairs.

#include <voussoir/base/text.h>
#include <voussoir/packing/cell_tree.h>
#include <voussoir/packing/polygons/polygon_checks.h>
#include <voussoir/packing/polygons/polygons.h>
#include <voussoir/run/command_line/command_line.h>

#include "own_directory.h"
#include "polygons.h"
#include "tests.h"
#include <filesystem>

namespace test_drawing_faults
{
using namespace Voussoir;
using dealii::Point;
namespace fs = std::filesystem;

/** A unit square with its lower left corner at (x, 0). */
std::string square(const int x)
{
  const auto vertex = [&](const int a, const int b) {
    return std::to_string(x + a) + " " + std::to_string(b);
  };
  return "POLYGON ((" + vertex(0, 0) + ", " + vertex(1, 0) + ", " +
         vertex(1, 1) + ", " + vertex(0, 1) + ", " + vertex(0, 0) + "))";
}

/** Faulty lines, three of each of ten kinds, from x = 100 on. */
std::string faulty_lines()
{
  std::string lines;
  for (int k = 0; k < 3; ++k)
  {
    const auto at = [&](const double x, const double y, const int kind) {
      return text(100 + 30 * kind + 10 * k + x, " ", y);
    };
    const auto ring =
        [&](const int kind,
            const std::vector<std::pair<double, double>> &vertices) {
          std::string words;
          for (const auto &[x, y] : vertices)
            words += (words.empty() ? "" : ", ") + at(x, y, kind);
          return words;
        };
    const auto polygon = [&](const std::string &rings,
                             const std::string &tail = "") {
      lines += "POLYGON (" + rings + ")" + tail + "\n";
    };
    lines += "POINT (1 2)\n";
    polygon("(" + ring(1, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}) + ")");
    polygon("(" + ring(2, {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}}) + "), (" +
            ring(2, {{1, 1}, {2, 1}, {2, 2}, {1, 1}}) + ")");
    polygon("(" + ring(3, {{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 0}}) + ")");
    polygon("(" + ring(4, {{0, 0}, {1, 0}, {2, 0}, {0, 0}}) + ")");
    polygon("(" + ring(5, {{0, 0}, {1, 1}, {1, 0}, {0, 1}, {0, 0}}) + ")");
    polygon("(" + ring(6, {{0, 0}, {1, 0}, {1, 1e-7}, {0, 0}}) + ")");
    polygon("(" + ring(7, {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}) + ")",
            ";ground");
    const std::string twice =
        "(" + ring(8, {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}) + ")";
    polygon(twice);
    polygon(twice);
    polygon("(" + ring(9, {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}) + ")");
    polygon("(" + ring(9, {{0.75, 0}, {2, 0}, {2, 1}, {0.75, 1}, {0.75, 0}}) +
            ")");
  }
  return lines;
}

void run(const std::string &content, const std::string &settings)
{
  write_file("drawing.wkt", content);
  write_file("drawing.prm", "set Output directory = results\n"
                            "subsection Packing\n"
                            "  set Generator = polygons\n"
                            "  subsection polygons\n"
                            "    set File = drawing.wkt\n" +
                                settings +
                                "  end\n"
                                "end\n");
  std::ostringstream out, error;
  const int status = run_command_line({"drawing.prm", "--quiet"}, out, error);
  std::cout << "status " << status << '\n' << error.str();
  for (const char *file :
       {"drawing_check.vtu", "drawing_check.html", "cells.csv", "summary.json"})
    if (fs::exists(fs::path("results") / file))
      std::cout << file << std::endl;
}

/** Distances by all pairs of vertices and sides, of random cells apart. */
void nearest()
{
  const Packing<2> packing = random_packing(60, 1);
  std::vector<std::vector<Point<2>>> rings(packing.n_cells());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      rings[c].push_back(packing.centre(c) +
                         0.8 * (packing.vertex(c, i) - packing.centre(c)));
  const CellTree tree(rings);
  const auto is_even = [](const unsigned int c) { return c % 2 == 0; };
  double error = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    double least = 1e9;
    for (unsigned int other = 0; other < packing.n_cells(); other += 2)
      for (const auto &[a, b] : {std::pair(rings[c], rings[other]),
                                 std::pair(rings[other], rings[c])})
        for (const Point<2> &p : a)
          for (std::size_t i = 0; i < b.size() && other != c; ++i)
          {
            const auto side = b[(i + 1) % b.size()] - b[i];
            const double t =
                std::clamp((p - b[i]) * side / side.norm_square(), 0., 1.);
            least = std::min(least, p.distance(b[i] + t * side));
          }
    const auto found = tree.nearest(c, is_even);
    error = std::max(error, std::abs(found->distance - least));
  }
  check_error("nearest cells", error, 1e-15);
  check("none that counts",
        !tree.nearest(3, [](unsigned int) { return false; }));
}

void run()
{
  work_in_own_directory();
  std::cout << "Two squares side by side" << std::endl;
  run(square(0) + "\n" + square(1) + "\n", "");
  std::cout << "Thirty faults; a stone that floats, and a gap" << std::endl;
  run(square(0) + "\n" + square(1) + "\n" + faulty_lines() +
          "POLYGON ((2.01 0, 3 0, 3 1, 2.01 1, 2.01 0))\n",
      "");
  std::cout << "One fault" << std::endl;
  run(square(0) + "\nPOLYGON ((2 0, 3 0, 3 1, 2 1))\n", "");
  std::cout << "Many of one kind" << std::endl;
  std::string many;
  for (int k = 0; k < 1000; ++k)
    many += "POINT (1 2)\n";
  run(many, "");
  std::cout << "A gap that stays open" << std::endl;
  run(square(0) + "\n" + square(1) +
          "\nPOLYGON ((2.01 0, 3 0, 3 1, 2.03 1, 2.01 0))\n",
      "");
  std::cout << "The same as a joint" << std::endl;
  run(square(0) + "\n" + square(1) +
          "\nPOLYGON ((2.01 0, 3 0, 3 1, 2.03 1, 2.01 0))\n",
      "    set Joint width = 0.03\n");
  std::cout << "A joint width in the unit of the file" << std::endl;
  run(square(0) + "\n" + square(1) +
          "\nPOLYGON ((2.01 0, 3 0, 3 1, 2.03 1, 2.01 0))\n",
      "    set Scale = 0.01\n"
      "    set Joint width = 0.03\n");
  std::cout << "Joints that cross" << std::endl;
  run("POLYGON ((0 0, 4 0, 4 1, 0 1, 0 0))\n"
      "POLYGON ((0 1.5, 4 1.5, 4 2.5, 0 2.5, 0 1.5))\n"
      "POLYGON ((0 1, 1.75 1, 1.75 1.5, 0 1.5, 0 1))\n"
      "POLYGON ((2.25 1, 4 1, 4 1.5, 2.25 1.5, 2.25 1))\n",
      "    set Joint width = 0.6\n");
  std::cout << "Two slates in a gap, whose ends leave its middle open"
            << std::endl;
  run("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n"
      "POLYGON ((0 1.02, 1 1.02, 1 2, 0 2, 0 1.02))\n"
      "POLYGON ((0 1.005, 0.49 1.005, 0.49 1.015, 0 1.015, 0 1.005))\n"
      "POLYGON ((0.51 1.005, 1 1.005, 1 1.015, 0.51 1.015, 0.51 1.005))\n",
      "");
  std::cout << "Nearly filled by a thin cell" << std::endl;
  run(square(0) + "\nPOLYGON ((1.02 0, 2 0, 2 1, 1.02 1, 1.02 0))\n"
                  "POLYGON ((1.005 0, 1.015 0, 1.015 1, 1.005 1, 1.005 0))\n",
      "");
  nearest();
}

const RoomTest test("drawing_faults", run);
} // namespace test_drawing_faults
