// SPDX-License-Identifier: LGPL-2.1-or-later

// The command line: help, version, --print-parameters, --set, the saved
// parameters, and results that do not depend on the directory of the call.

#include "own_directory.h"
#include "run_program.h"
#include "tests.h"
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace test_options
{
namespace fs = std::filesystem;

/** The standard output; "FAILED" if the status is not zero. */
std::string run(const std::vector<std::string> &arguments)
{
  const Ended ended = run_program(arguments);
  return ended.status == 0 ? ended.out : "FAILED: " + ended.error;
}

void run()
{
  work_in_own_directory();

  std::cout << run({"--help"});
  check("version", run({"--version"}).rfind("voussoir ", 0) == 0);

  // The printed parameters are a parameter file, and describe themselves.
  const std::string printed = run({"--print-parameters"});
  std::ofstream("printed.prm") << printed;
  check("printed parameters can be read",
        run({"printed.prm", "--print-parameters"}) == printed);
  const std::string changed =
      run({"printed.prm", "--print-parameters", "--set", "Friction/Strength=7",
           "--set", "Packing/Voronoi/Seed=8", "--set", "Title=a = b"});
  for (const char *line :
       {"set Strength             = 7", "set Seed             = 8",
        "set Title            = a = b"})
    check(line, changed.find(line) != std::string::npos);

  // Paths in a .prm file begin at that file.
  fs::create_directories("sub");
  std::ofstream("sub/points.txt") << "0.2 0.5\n0.8 0.5\n";
  std::ofstream("sub/scene.prm")
      << "set Output directory = output/scene\n"
         "subsection Packing\n subsection Voronoi\n  set Points = file\n"
         "  set Points file = points.txt\n end\nend\n"
         "subsection Loads\n set Traction = -nx; -ny\nend\n";
  const std::string out = run({"sub/scene.prm"});
  check("the scene runs", out.find("solved") != std::string::npos);
  for (const char *file :
       {"interfaces.csv", "cells.csv", "boundary.csv", "blocks.vtu",
        "interfaces.vtu", "stress.vtu", "results.pvd", "report.html",
        "parameters.prm", "summary.json"})
    check(file, fs::file_size(std::string("output/scene/") + file) > 0);
  check("nothing is left over",
        std::distance(fs::directory_iterator("output/scene"),
                      fs::directory_iterator()) == 10);
  std::cout << content_of("output/scene/interfaces.csv");

  // Quiet shows the summary alone, of at most ten lines.
  const std::string quiet =
      run({"sub/scene.prm", "--set", "Output/Verbosity=0"});
  check("at most ten lines",
        std::count(quiet.begin(), quiet.end(), '\n') <= 10);

  check("--quiet shows nothing", run({"sub/scene.prm", "--quiet"}).empty());
  const auto quiet_warnings = [](std::vector<std::string> words) {
    words.insert(words.begin(), {"sub/scene.prm", "--quiet"});
    const Ended ended = run_program(words);
    return ended.out.empty() ? ended.error : "FAILED: " + ended.out;
  };
  std::cout << quiet_warnings({"--set", "Loads/Traction=0; 0"});

  // What belongs to another choice has no effect, and is named.
  std::cout << quiet_warnings(
      {"--set", "Packing/wall/Courses=3", "--set", "Packing/wall/Width=2",
       "--set", "Solver/least energy/Modulus=7", "--set",
       "Stress/Refinements=1", "--set", "Loads/Stress=1, 0; 0, 1", "--set",
       "Packing/Voronoi/Seed=3", "--set", "Packing/arch/Thickness=0.20"});
  check("what is used is not named",
        quiet_warnings(
            {"--set", "Accuracy=fine", "--set", "Stress/Refinements=1"})
            .empty());

  // Set is what the user has set, be it the default; a listing sets nothing.
  std::cout << quiet_warnings({"--set", "Friction/Coefficient=0.6"});
  std::ofstream("sub/default.prm")
      << content_of("sub/scene.prm")
      << "subsection Friction\n set Law = Tresca\n set Cohesion = 0\nend\n";
  run({"sub/default.prm"});
  const auto warnings_of_file = [](const std::string &file) {
    return run_program({file, "--quiet"}).error;
  };
  std::cout << warnings_of_file("sub/default.prm");
  fs::copy("output/scene/parameters.prm", "sub/again.prm");
  check("a listing of all parameters warns of none",
        warnings_of_file("sub/again.prm").empty());
  std::ofstream("sub/printed.prm")
      << run({"sub/scene.prm", "--print-parameters"});
  check("nor does one that is printed",
        warnings_of_file("sub/printed.prm").empty());
  std::ofstream("sub/printed.prm")
      << run({"sub/scene.prm", "--print-parameters", "--set",
              "Friction/Coefficient=0.7"});
  std::cout << warnings_of_file("sub/printed.prm");

  // What is not asked for is not written, and no older file stays.
  const auto files_with = [](const std::string &setting,
                             const std::string &other = "Title=files") {
    run({"sub/scene.prm", "--set", setting, "--set", other});
    std::set<std::string> names;
    for (const auto &file : fs::directory_iterator("output/scene"))
      names.insert(file.path().filename());
    return names;
  };
  using Names = std::set<std::string>;
  const Names always = {"parameters.prm", "summary.json"};
  const Names csv = {"interfaces.csv", "cells.csv", "boundary.csv"};
  const Names report = {"report.html"};
  const Names vtu = {"blocks.vtu", "interfaces.vtu", "stress.vtu",
                     "results.pvd"};
  const auto also = [](Names a, const Names &b) {
    a.insert(b.begin(), b.end());
    return a;
  };
  check("draft: no stress.vtu",
        files_with("Accuracy=draft").count("stress.vtu") == 0);
  check("all", files_with("Output/Files=all") ==
                   also(also(also(always, csv), vtu), report));
  check("no report",
        files_with("Output/Report=false") == also(also(always, csv), vtu));
  check("a report alone",
        files_with("Output/Files=none", "Output/Report=true") ==
            also(always, report));
  check("csv", files_with("Output/Files=csv") == also(always, csv));
  check("vtu", files_with("Output/Files=vtu") == also(always, vtu));
  check("none", files_with("Output/Files=none") == always);
}

const RoomTest test("options", run);
} // namespace test_options
