// SPDX-License-Identifier: LGPL-2.1-or-later

// What is wrong with the blocks of a file and can be mended is told in the
// page, in summary.json and in a grid of points for ParaView, with its numbers.
// A file without defects has none of these.

#include <nlohmann/json.hpp>

#include "models.h"
#include "own_directory.h"
#include "run_program.h"
#include <filesystem>

namespace test_space_defects
{
namespace fs = std::filesystem;

/** Run the file blocks.obj, and return summary.json. */
nlohmann::json summary_of(const std::string &blocks)
{
  write_file("blocks.obj", blocks);
  write_file("scene.prm",
             "set Dimension = 3\nsubsection Packing\n set Generator = model\n"
             " subsection model\n  set File = blocks.obj\n end\nend\n");
  const Ended ended = run_program({"scene.prm", "--quiet"});
  if (ended.status != 0)
    std::cout << "FAILED: " << ended.message() << std::endl;
  return nlohmann::json::parse(content_of("output/summary.json"));
}

void run()
{
  work_in_own_directory();
  Shape repeated = cube(1.);
  repeated.faces.push_back(repeated.faces[2]);
  Shape bent = cube(0., 0., 1.);
  bent.vertices[7][2] += 0.01;
  const nlohmann::json summary = summary_of(
      obj_of("unwelded", unwelded(cube())) + obj_of("repeated", repeated) +
      obj_of("bent", bent) + obj_of("deep", cube(2.4, 0.5)) +
      obj_of("in it", cube(3.3, 0.5)));
  for (const nlohmann::json &kind : summary["packing"]["defects"])
    std::cout << kind.dump() << std::endl;
  const std::string page = content_of("output/report.html");
  for (const char *const words :
       {"Defects of blocks", "faces listed twice", "taken once",
        "blocks that penetrate others", "'in it'", "face 6"})
    std::cout << words << ": " << (page.find(words) != page.npos) << std::endl;
  std::cout << content_of("output/results.pvd");
  check("a grid of points",
        content_of("output/defects.vtu").find("Name=\"kind\"") !=
            std::string::npos);

  const nlohmann::json clean = summary_of(obj_of("a", cube()));
  check("without defects none", clean["packing"]["defects"].empty());
  check("nor a grid", !fs::exists("output/defects.vtu"));
  check("nor a table",
        content_of("output/report.html").find("Defects of blocks") ==
            std::string::npos);
}

const RoomTest test("space_defects", run);
} // namespace test_space_defects
