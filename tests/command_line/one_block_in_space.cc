// SPDX-License-Identifier: LGPL-2.1-or-later

// One block in space without any joint: what acts on it balances, and its
// stress is that of its tractions; pressed from all sides it has no tension.

#include <nlohmann/json.hpp>

#include "own_directory.h"
#include "run_scene.h"
#include "table.h"
#include "tests.h"

namespace test_one_block_in_space
{
using namespace Voussoir;

const char *scene = "set Dimension = 3\n"
                    "set Rotations = true\n"
                    "subsection Packing\n"
                    " subsection Voronoi\n  set Number of points = 1\n end\n"
                    "end\n"
                    "subsection Loads\n"
                    " set Traction = -2*nx; -2*ny; -3*nz\n"
                    "end\n";

SceneRunner run_scene(scene);

nlohmann::json summary()
{
  return nlohmann::json::parse(content_of("output/summary.json"));
}

void check_stress(const std::string &accuracy)
{
  check("status with " + accuracy,
        run_scene({"--set", "Accuracy=" + accuracy}) == 0);
  const nlohmann::json found = summary();
  const nlohmann::json &stress = found["stress"];
  check_error(
      "  the least stress",
      std::abs(stress["principal_stress_min"]["value"].get<double>() + 3.),
      1e-12);
  check_error(
      "  the greatest is a pressure, too",
      std::abs(stress["principal_stress_max"]["value"].get<double>() + 2.),
      1e-12);
  const Table cells = read_table("output/cells.csv");
  check_error("  the mean stress",
              std::abs(cells.at("sxx").at(0) + 2.) +
                  std::abs(cells.at("syy").at(0) + 2.) +
                  std::abs(cells.at("szz").at(0) + 3.),
              1e-12);
  bool has_times = true;
  for (const std::string stage : {"packing", "statics", "stress", "output"})
    has_times = has_times && found["timings"].at(stage).get<double>() >= 0.;
  check("  the time of each stage", has_times);
}

void run()
{
  work_in_own_directory();
  for (const std::string accuracy : {"draft", "standard", "fine"})
    check_stress(accuracy);
  check("out of balance",
        run_scene({"--set", "Loads/Traction=1; 0; -3*nz"}) != 0);
}

const RoomTest test("one_block_in_space", run);
} // namespace test_one_block_in_space
