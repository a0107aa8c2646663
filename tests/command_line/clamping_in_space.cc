// SPDX-License-Identifier: LGPL-2.1-or-later

// `Clamping` in space, as the user sees it: a row of two bricks that rests on
// the ground, or is held at both ends, or at one; with loads and without. It
// is not there unless it is asked for.

#include <nlohmann/json.hpp>

#include "own_directory.h"
#include "run_scene.h"
#include "table.h"
#include "tests.h"

namespace test_clamping_in_space
{
using namespace Voussoir;

const char *scene = "set Dimension = 3\n"
                    "set Rotations = true\n"
                    "subsection Packing\n set Generator = wall\n"
                    " subsection wall\n  set Length = 4\n  set Thickness = 1\n"
                    "  set Height = 1\n  set Brick length = 2\n"
                    "  set Brick height = 1\n  set Brick width = 1\n"
                    "  set Bond = stack\n"
                    " end\nend\n"
                    "subsection Friction\n set Strength = 1\nend\n";

SceneRunner run_scene(scene);

/** The summary of a run with supports where a condition holds. */
nlohmann::json summary(const std::string &where,
                       std::vector<std::string> arguments)
{
  for (const std::string &more :
       {std::string("--set"), "Supports/Where=" + where})
    arguments.push_back(more);
  check("status with " + where, run_scene(arguments) == 0);
  return nlohmann::json::parse(content_of("output/summary.json"));
}

const std::vector<std::string> clamping = {"--set", "Clamping=true"},
                               with_weight = {"--set", "Clamping=true", "--set",
                                              "Loads/Body force=0; 0; -0.1"};

void clamped()
{
  for (const auto &arguments : {clamping, with_weight})
  {
    const nlohmann::json found = summary("nx*nx > 0.5", arguments)["clamping"];
    check("  clamped", found["clamped"] == true &&
                           !found.contains("least_opening") &&
                           found["self_stress"]["interfaces"] == 3);
    check_error("  balance",
                found["self_stress"]["equilibrium_residual"].get<double>() +
                    found["self_stress"]["moment_residual"].get<double>(),
                1e-14);
    const Table interfaces = read_table("output/interfaces.csv");
    double error = 0.;
    for (const double force : interfaces.at("self_stress"))
      error = std::max(error, std::abs(force + 1.));
    check_error("  pressed by one", error, 1e-14);
    check("  without a motion",
          read_table("output/cells.csv").count("opening_displacement_x") == 0);
    check("  as the terminal says",
          run_scene.last_output.find("The supports clamp the packing") !=
              std::string::npos);
  }
}

void open()
{
  for (const std::string where : {"z < 1e-9", "nx < -0.5"})
    for (const auto &arguments : {clamping, with_weight})
    {
      if (where != "z < 1e-9" && arguments == with_weight)
        continue; // friction alone, of which there is not enough
      const nlohmann::json found = summary(where, arguments)["clamping"];
      check("  opens", found["clamped"] == false &&
                           found["least_opening"].get<double>() > 0.1 &&
                           !found.contains("self_stress"));
      check("  without pressures",
            read_table("output/interfaces.csv").count("self_stress") == 0);
      // The bricks part, and leave the ground.
      const Table cells = read_table("output/cells.csv");
      const std::string along = where == "z < 1e-9" ? "opening_displacement_z"
                                                    : "opening_displacement_x";
      const std::vector<double> &x = cells.at("opening_displacement_x");
      check("  by a motion", cells.at("x")[0] < cells.at("x")[1] &&
                                 x[1] > x[0] && cells.at(along)[0] > 0.);
    }
}

void run()
{
  work_in_own_directory();
  clamped();
  open();
  check("not asked for",
        !summary("z < 1e-9", {}).contains("clamping") &&
            read_table("output/cells.csv").count("opening_displacement_x") ==
                0);
}

const RoomTest test("clamping_in_space", run);
} // namespace test_clamping_in_space
