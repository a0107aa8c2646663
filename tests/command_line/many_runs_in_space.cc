// SPDX-License-Identifier: LGPL-2.1-or-later

// Sweeps and searches in space: every line of sweep.csv is the run of its
// values alone, an angle turns a push, packings are shared, the search ends
// around a limit that is known, and what is wrong ends with a message and no
// file.

#include <nlohmann/json.hpp>

#include "own_directory.h"
#include "run_scene.h"
#include "table.h"
#include "tests.h"
#include <cmath>
#include <filesystem>
#include <fstream>

namespace test_many_runs_in_space
{
namespace fs = std::filesystem;
using namespace Voussoir;

// A block of 1 x 2 x 4 on the ground, of weight 1 a unit of volume. Pushed by a
// times its weight along an axis it slides with a > mu, or turns over an edge
// with a > w/h: 1/4 along x, and 1/2 along y.
const char *scene = "set Dimension = 3\n"
                    "set Rotations = true\n"
                    "set Analysis = load factor\n"
                    "subsection Packing\n set Generator = wall\n"
                    " subsection wall\n  set Length = 1\n  set Thickness = 2\n"
                    "  set Height = 4\n  set Brick length = 1\n"
                    "  set Brick height = 4\n  set Brick width = 2\n"
                    "  set Bond = stack\n"
                    " end\nend\n"
                    "subsection Supports\n set Where = z < 1e-9\nend\n"
                    "subsection Loads\n set Body force = 0; 0; -1\nend\n"
                    "subsection Live loads\n set Body force = 1; 0; 0\nend\n"
                    "subsection Friction\n set Law = associated Coulomb\n"
                    " set Coefficient = 0.6\nend\n";

SceneRunner run_scene(scene);

/** The words of all lines of a table. */
std::vector<std::vector<std::string>> words_of(const std::string &file)
{
  std::ifstream in(file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);)
    boost::split(rows.emplace_back(), line, boost::is_any_of(","));
  return rows;
}

/** The status in a line of the sweep, from 1 on. */
std::string status_of(const unsigned int line)
{
  const auto rows = words_of("output/sweep.csv");
  const auto &head = rows.at(0);
  return rows.at(line).at(std::find(head.begin(), head.end(), "status") -
                          head.begin());
}

nlohmann::json summary_in(const std::string &directory)
{
  return nlohmann::json::parse(content_of(directory + "/summary.json"));
}

/** The factor of a push by an angle, which an edge or friction ends. */
double factor_of_push(const double angle)
{
  return std::min(
      {0.25 / std::abs(std::cos(angle)), 0.5 / std::abs(std::sin(angle)), 0.6});
}

void check_angles()
{
  check(
      "the status of a sweep",
      run_scene({"--sweep",
                 "Live loads/Body force=cos(a*pi/180); 0+sin(a*pi/180); 0 for "
                 "a=-180:180:25",
                 "--result", "load_factor/bound"}) == 0);
  const Table table = read_table("output/sweep.csv");
  const std::vector<double> &angle = table.at("a");
  double error = 0.;
  for (unsigned int k = 0; k < angle.size(); ++k)
    error = std::max(error, std::abs(table.at("load_factor")[k] /
                                         factor_of_push(angle[k] * M_PI / 180) -
                                     1.));
  check("a line for each angle", angle.size() == 25);
  check_error("a push in any direction", error, 1e-8);
  check("above it no factor",
        table.at("load_factor/bound") == table.at("load_factor_bound"));
  check("iterations", table.at("iterations")[3] > 0.);
  const std::string page = content_of("output/sweep.html");
  check("a plot over the angle", page.find("<title>a = -180: ") != page.npos);
  // The same run alone.
  run_scene({"--set", "Output directory=alone", "--set",
             "Live loads/Body force=cos(30*pi/180); sin(30*pi/180); 0"},
            false);
  check("as alone", summary_in("alone")["load_factor"]["carried"] ==
                        table.at("load_factor").at(14));
}

void check_directories()
{
  fs::remove_all("output");
  run_scene({"--sweep", "Friction/Coefficient=0.2 | 0.6", "--sweep",
             "Rotations=false | true", "--directories"});
  check("a directory each", fs::exists("output/run_1/interface_points.csv") &&
                                fs::exists("output/run_4/report.html"));
  const Table table = read_table("output/sweep.csv");
  bool are_alike = true;
  for (unsigned int k = 0; k < 4; ++k)
    are_alike = are_alike &&
                summary_in("output/run_" +
                           std::to_string(k + 1))["load_factor"]["carried"] ==
                    table.at("load_factor").at(k);
  check("each has its factor", are_alike);
  // Sliding at mu, but for the last, which turns over.
  const std::vector<double> known = {0.2, 0.2, 0.6, 0.25};
  double error = 0.;
  for (unsigned int k = 0; k < 4; ++k)
    error =
        std::max(error, std::abs(table.at("load_factor")[k] / known[k] - 1.));
  check_error("which is known", error, 1e-8);
}

void check_search(const std::string &range,
                  const double limit,
                  const std::string &load)
{
  check("the status of a search",
        run_scene({"--find", range, "--set", "Analysis=state", "--set",
                   "Loads/Body force=" + load},
                  false) == 0);
  const auto rows = words_of("output/sweep.csv");
  const std::string at_low = status_of(1);
  double low = -1e9, high = 1e9;
  for (unsigned int k = 1; k < rows.size(); ++k)
  {
    const double value = std::stod(rows[k][0]);
    if (status_of(k) == at_low)
      low = std::max(low, value);
    else
      high = std::min(high, value);
  }
  check("the limit is between them",
        low <= limit * (1. + 1e-9) && limit * (1. - 1e-9) <= high);
  check_error("width", (high - low) / limit, 1e-6);
  check("both are named",
        run_scene.last_output.find("is carried") != std::string::npos &&
            run_scene.last_output.find("collapses") != std::string::npos);
}

void check_packings()
{
  // Another packing in each run; without loads there is nothing to be found.
  run_scene({"--sweep", "Packing/wall/Height=4:16:3:log", "--result",
             "packing/volume", "--set", "Analysis=state", "--set",
             "Loads/Body force=0; 0; 0"});
  const Table table = read_table("output/sweep.csv");
  bool are_right = true;
  for (unsigned int k = 0; k < 3; ++k)
    are_right =
        are_right &&
        std::abs(table.at("packing/volume").at(k) / (8 << k) - 1.) < 1e-12;
  check("packings that change", are_right);
  check("no verdict", status_of(1) == "packing");
  run_scene({"--find", "Packing/wall/Height=4:8", "--set", "Analysis=state",
             "--set", "Loads/Body force=0; 0; 0"});
}

void check_warnings()
{
  run_scene({"--sweep", "Friction/Coefficient=0.3 | 0.6", "--set",
             "Friction/Strength=2"},
            false);
  std::cout << run_scene.last_output;
}

/** Of a file in which a block penetrates another, shared and with notices. */
void check_models()
{
  std::ofstream("blocks.off") << "OFF\n16 12 0\n"
                                 "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                                 "0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                                 "0 0 0.8\n1 0 0.8\n1 1 0.8\n0 1 0.8\n"
                                 "0 0 2\n1 0 2\n1 1 2\n0 1 2\n"
                                 "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n"
                                 "4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"
                                 "4 11 10 9 8\n4 12 13 14 15\n"
                                 "4 8 9 13 12\n4 9 10 14 13\n"
                                 "4 10 11 15 14\n4 11 8 12 15\n";
  fs::remove_all("output");
  fs::create_directories("output/run_2");
  fs::copy("blocks.off", "output/run_2/packing.off");
  const std::vector<std::string> of_model = {
      "--set", "Packing/Generator=model",
      "--set", "Loads/Body force=0; 0; 0",
      "--set", "Analysis=state",
      "--set", "Packing/model/File=output/run_2/packing.off"};
  std::vector<std::string> words = of_model;
  words.insert(words.end(), {"--sweep", "Rotations=false | true", "--result",
                             "packing/defects/0/blocks"});
  run_scene(words);
  std::cout << run_scene.last_output;
  words.insert(words.end(), {"--directories", "--set", "Output/Packing=OFF"});
  run_scene(words);
  check("the file is kept",
        content_of("output/run_2/packing.off") == content_of("blocks.off"));
}

void check_dimensions()
{
  std::ofstream("any.prm")
      << "subsection Packing\n set Generator = wall\nend\n";
  const Ended ended = run_program(
      {"any.prm", "--sweep", "Dimension=2 | 3", "--result", "packing/cells"});
  std::cout << ended.message();
  check("either", status_of(1) == "solved" && status_of(2) == "packing");
  fs::remove_all("output");
  run_scene({"--sweep", "Dimension=2 | 3"});
  check("nothing is written", !fs::exists("output"));
}

void run()
{
  work_in_own_directory();
  check_angles();
  check_directories();
  check_search("Friction/Coefficient=0:1", 0.2, "0.2; 0; -1");
  check_search("Loads/Body force=h; 0; -1 for h=0:1:1e-8", 0.25, "0; 0; -1");
  check_packings();
  check_warnings();
  check_models();
  check_dimensions();
  run_scene({"--find", "Friction/Coefficient=0.3:0.6"});
  fs::remove_all("output");
  run_scene({"--sweep", "Live loads/Body force=1; 0; 0 for a=0:90:4"});
  run_scene({"--sweep", "Live loads/Body force=a; 0; 0 for a=0:90"});
  run_scene({"--find", "Live loads/Body force=a; 0; 0 for a=0"});
  run_scene({"--sweep", "Live loads/Body force=a; 0; 1/a for a=1 | 0"});
  check("nothing is written", !fs::exists("output"));
}

const RoomTest test("many_runs_in_space", run);
} // namespace test_many_runs_in_space
