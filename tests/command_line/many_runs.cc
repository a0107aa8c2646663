// SPDX-License-Identifier: LGPL-2.1-or-later

// Sweeps and searches: every line of sweep.csv is the run of its values alone,
// the search ends around a limit that is known, and what is wrong ends with a
// message and no file.

#include <voussoir/run/sweep/sweep_values.h>

#include "own_directory.h"
#include "run_scene.h"
#include "table.h"
#include "tests.h"
#include <filesystem>
#include <fstream>

namespace test_many_runs
{
namespace fs = std::filesystem;
using namespace Voussoir;

// A block of width 1 and height 2 on the ground, of weight 1 a unit of area,
// pushed by H times its weight: it slides if H * 2 > s, and turns over if
// H > 1/2.
const char *scene = "set Formulation = least energy\n"
                    "subsection Packing\n set Generator = wall\n"
                    " subsection wall\n  set Courses = 1\n"
                    "  set Bricks per course = 1\n"
                    "  set Width = 1\n  set Height = 2\n"
                    " end\nend\n"
                    "subsection Supports\n set Where = y < 1e-9\nend\n"
                    "subsection Loads\n set Body force = 0.25; -1\nend\n"
                    "subsection Friction\n set Strength = 10\nend\n";

SceneRunner run_scene(scene);

std::vector<std::string> lines_of(const std::string &file)
{
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

std::size_t count(const std::string &text, const std::string &what)
{
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; ++at)
    ++n;
  return n;
}

/** The page of a sweep has a point for each number that it plots. */
void check_page(const unsigned int n_runs, const unsigned int n_collapsed)
{
  std::ifstream in("output/sweep.html");
  const std::string page((std::istreambuf_iterator<char>(in)), {});
  check("the rows of the page", count(page, "<tr>") == n_runs + 1);
  // Either a utilisation or the work, and the number of iterations.
  check("its points", count(page, "<circle") == 2 * n_runs);
  check("those that collapse",
        count(page, "circle class=\"collapse\"") == 2 * n_collapsed);
  check("a circle is where its title says",
        count(page, "<title>Friction/Strength = 0.1: ") == 2);
}

/** A field of a line without quotation marks. */
std::string
field(const std::string &line, const std::string &name, const std::string &head)
{
  std::vector<std::string> names, words;
  boost::split(names, head, boost::is_any_of(","));
  boost::split(words, line, boost::is_any_of(","));
  return words.at(std::find(names.begin(), names.end(), name) - names.begin());
}

void check_sweep()
{
  const int status =
      run_scene({"--sweep", "Friction/Strength=0.1:0.9:9", "--sweep",
                 "Rotations=false | true", "--result", "ground/reaction/1",
                 "--result", "loads/total/0"});
  check("the status of a sweep", status == 0);
  const std::vector<std::string> lines = lines_of("output/sweep.csv");
  check("a line for each run", lines.size() == 1 + 9 * 2);
  bool are_right = true, are_alike = true;
  for (std::size_t k = 1; k < lines.size(); ++k)
  {
    const std::string strength = field(lines[k], "Friction/Strength", lines[0]);
    const std::string turns = field(lines[k], "Rotations", lines[0]);
    const bool carries = std::stod(strength) >= 0.5;
    are_right = are_right && field(lines[k], "status", lines[0]) ==
                                 (carries ? "solved" : "collapse");
    are_right =
        are_right && field(lines[k], "loads/total/0", lines[0]) == "0.5" &&
        (!carries ||
         std::abs(std::stod(field(lines[k], "ground/reaction/1", lines[0])) -
                  2.) < 1e-9);
    const int alone = run_scene({"--set", "Output directory=alone", "--set",
                                 "Friction/Strength=" + strength, "--set",
                                 "Rotations=" + turns},
                                false);
    are_alike = are_alike && alone == (carries ? 0 : 3);
  }
  check("each verdict and each number is known", are_right);
  check("each run alone ends alike", are_alike);
  check("ends are as given", lines[1].compare(0, 4, "0.1,") == 0 &&
                                 lines.back().compare(0, 4, "0.9,") == 0);
}

void check_packings()
{
  // The packing is another one in each run.
  run_scene(
      {"--sweep", "Packing/wall/Height=1:4:3:log", "--result", "packing/area"},
      false);
  const std::vector<std::string> lines = lines_of("output/sweep.csv");
  bool are_right = lines.size() == 4;
  for (unsigned int k = 1; are_right && k < 4; ++k)
    are_right = std::abs(std::stod(field(lines[k], "packing/area", lines[0])) -
                         (1 << (k - 1))) < 1e-12;
  check("packings that change, in equal ratios", are_right);
}

void check_directories()
{
  fs::remove_all("output");
  run_scene({"--sweep", "Friction/Strength=0.1:0.9:9", "--result",
             "solver/iterations"},
            false);
  check_page(9, 4);
  fs::remove_all("output");
  run_scene({"--sweep", "Friction/Strength=0.1 | 10", "--directories"}, false);
  check("a directory each", fs::exists("output/run_1/mechanism.csv") &&
                                fs::exists("output/run_2/interfaces.csv") &&
                                fs::exists("output/run_2/report.html") &&
                                fs::exists("output/sweep.csv"));
}

/** Both ends of the factors that are carried: it slides, or is lifted. */
void check_both_ends()
{
  run_scene({"--sweep", "Load factor/Direction=greatest | least", "--set",
             "Analysis=load factor", "--set", "Load factor/Factor=all loads"},
            false);
  const std::vector<std::string> lines = lines_of("output/sweep.csv");
  const auto factor = [&](const unsigned int k) {
    return std::stod(field(lines[k], "load_factor", lines[0]));
  };
  check("both ends", lines.size() == 3 &&
                         std::abs(factor(1) / 20. - 1.) < 1e-8 &&
                         std::abs(factor(2)) < 1e-8);
}

void check_search(const std::vector<std::string> &with,
                  const double limit,
                  const std::string &carried,
                  const std::string &collapses)
{
  std::vector<std::string> arguments = {"--find", with[0]};
  for (std::size_t k = 1; k < with.size(); ++k)
    arguments.insert(arguments.end(), {"--set", with[k]});
  check("the status of a search", run_scene(arguments, false) == 0);
  const std::vector<std::string> lines = lines_of("output/sweep.csv");
  double low = -1e9, high = 1e9;
  for (std::size_t k = 1; k < lines.size(); ++k)
  {
    const double value = std::stod(lines[k]);
    const std::string status = field(lines[k], "status", lines[0]);
    if (status == carried)
      low = std::max(low, value);
    if (status == collapses)
      high = std::min(high, value);
  }
  check("the limit is between them",
        low <= limit * (1. + 1e-12) && limit * (1. - 1e-12) <= high);
  check_error("width", (high - low) / std::abs(limit), 1e-6);
  check("both are named",
        run_scene.last_output.find("is carried") != std::string::npos &&
            run_scene.last_output.find("collapses") != std::string::npos);
}

/** Two blocks that touch where a corner of one meets a side of the other. */
void write_corner()
{
  std::ofstream("corner.wkt") << "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))\n"
                                 "POLYGON ((1 1, 1.5 2, 0.5 2, 1 1))\n";
}

/** The settings of that scene, of which the upper block has no weight. */
std::vector<std::string> corner(const std::vector<std::string> &words)
{
  std::vector<std::string> all;
  for (const char *setting :
       {"Packing/Generator=polygons", "Packing/polygons/File=corner.wkt",
        "Loads/Body force=0; y < 1 ? -1 : 0"})
    all.insert(all.end(), {"--set", setting});
  all.insert(all.end(), words.begin(), words.end());
  return all;
}

/** What a packing is made from may be any entry, in any order. */
void check_shared_packings()
{
  write_corner();
  for (const char *order : {"false | true", "true | false"})
  {
    run_scene(corner({"--sweep", "Friction/Strength=1 | 2", "--sweep",
                      std::string("Rotations=") + order, "--result",
                      "packing/interfaces"}),
              false);
    const std::vector<std::string> lines = lines_of("output/sweep.csv");
    bool are_right = lines.size() == 5;
    for (std::size_t k = 1; are_right && k < lines.size(); ++k)
      are_right =
          field(lines[k], "packing/interfaces", lines[0]) ==
          (field(lines[k], "Rotations", lines[0]) == "true" ? "2" : "1");
    check(std::string("corners bear where blocks turn: ") + order, are_right);
  }
  fs::remove_all("output");
  // Alone it is refused where they do not turn, and so it is here.
  run_scene(corner({"--sweep", "Rotations=true | false", "--set",
                    "Loads/Body force=0; -1"}));
  check("none is written", !fs::exists("output"));
}

/** Each warning of a run alone is one of the sweep, once. */
void check_warnings()
{
  const std::vector<std::string> words =
      corner({"--set", "Friction/Coefficient=0.6", "--sweep",
              "Friction/Strength=1 | 2", "--sweep", "Rotations=false | true"});
  run_scene(words, false);
  std::cout << run_scene.last_output;
  const std::vector<std::string> lines = lines_of("output/sweep.csv");
  check("in each line", count(lines[1], "'Coefficient' in") == 1 &&
                            count(lines[1], "corner only") == 0 &&
                            count(lines[2], "'Coefficient' in") == 1 &&
                            count(lines[2], "corner only") == 1 &&
                            count(lines[4], "corner only") == 1);
  std::ifstream in("output/sweep.html");
  const std::string page((std::istreambuf_iterator<char>(in)), {});
  check("on the page", count(page, "class=\"warning\"") == 3);
  // What is doubtful of forces, and the packing, as on the terminal of one run.
  run_scene({"--sweep", "Friction/Strength=4 | 5", "--set",
             "Loads/Body force=0.6; -1"},
            false);
  check("of forces", count(run_scene.last_output, "would overturn") == 1);
  run_scene(
      {"--set", "Friction/Strength=4", "--set", "Loads/Body force=0.6; -1"},
      false);
  check("as alone", count(run_scene.last_output, "would overturn") == 1);
}

/** A factor without a bound is infinite, and no point of a plot. */
void check_unbounded()
{
  // Pushed by 1 and pressed by 2: friction follows from mu = 1/2 on.
  run_scene({"--sweep", "Friction/Coefficient=0.2 | 0.3 | 0.4 | 0.6 | 0.8",
             "--set", "Friction/Law=associated Coulomb", "--set",
             "Loads/Body force=0; -1", "--set", "Analysis=load factor", "--set",
             "Live loads/Body force=1; -2", "--result", "load_factor/carried"},
            false);
  const std::vector<std::string> lines = lines_of("output/sweep.csv");
  bool are_right = lines.size() == 6;
  for (unsigned int k = 1; are_right && k < 6; ++k)
  {
    const std::string factor = field(lines[k], "load_factor", lines[0]);
    const double mu = std::stod(lines[k]);
    are_right =
        factor == field(lines[k], "load_factor/carried", lines[0]) &&
        (mu > 0.5
             ? factor == "inf"
             : std::abs(std::stod(factor) * (1. - 2. * mu) / mu - 1.) < 1e-8);
  }
  check("infinite where there is no bound", are_right);
  std::ifstream in("output/sweep.html");
  const std::string page((std::istreambuf_iterator<char>(in)), {});
  // Of the factor, twice, and of the utilisation, which all runs have.
  check("three points, and words on two",
        count(page, "<title>Friction/Coefficient = ") == 3 + 5 + 3 &&
            count(page, "load_factor has no bound in 2 of 5 runs") == 1);
  run_scene({"--sweep", "Load factor/Direction=greatest | least", "--set",
             "Loads/Body force=0; -1", "--set", "Analysis=load factor", "--set",
             "Live loads/Body force=0; 1"},
            false);
  check("the least one", field(lines_of("output/sweep.csv")[2], "load_factor",
                               lines_of("output/sweep.csv")[0]) == "-inf");
}

/** A result that no run has is refused, and the runs are written. */
void check_results()
{
  for (const char *wrong : {"grund/reaction/1", "ground/reaction/2", "forces"})
  {
    fs::remove_all("output");
    run_scene({"--sweep", "Friction/Strength=1 | 2", "--result", wrong});
    check("the runs are kept", lines_of("output/sweep.csv").size() == 3);
  }
  run_scene(
      {"--sweep", "Friction/Strength=1 | 2", "--result", "grund/reaction/1"},
      false);
  check(
      "said after the first run",
      run_scene.last_output.find("The first run has no 'grund/reaction/1', but "
                                 "'ground/reaction/0', 'ground/reaction/1'.") <
          run_scene.last_output.find("Sweep "));
  // What only some runs have is empty in the others.
  check("of some runs", run_scene({"--sweep", "Friction/Strength=0.1 | 1",
                                   "--result", "mechanism/closing_violation",
                                   "--result", "ground/reaction/1"},
                                  false) == 0);
  run_scene(
      {"--find", "Friction/Strength=0:10:1e-1", "--result", "grund/load"});
}

/** A file that the packing is read from is not overwritten. */
void check_inputs()
{
  fs::remove_all("output");
  fs::create_directories("output/run_2");
  write_corner();
  fs::copy("corner.wkt", "output/run_2/packing.wkt");
  run_scene(corner({"--sweep", "Friction/Strength=1 | 2", "--directories",
                    "--set", "Output/Packing=WKT", "--set",
                    "Packing/polygons/File=output/run_2/packing.wkt"}));
  check("it is kept", lines_of("output/run_2/packing.wkt").size() == 2);
}

/** Texts may be lists of as many numbers as there are joints. */
void check_long_lists()
{
  std::string list = "list 0", a = "a";
  for (unsigned int k = 0; k < 200000; ++k)
  {
    list += ", 1";
    a += 'b';
  }
  const SweepAxis axis = read_sweep_axis("Friction/Strength=" + list + " | 2");
  check("a long list", axis.values[0] == list);
  const SweepAxis words =
      read_sweep_axis("Loads/Body force=-" + a + ";" + a + "_;" + list +
                      " for " + a + " = -1:2:4");
  check("a long word", words.of.variable == a &&
                           words.of.assignment("-1") ==
                               "Loads/Body force=-(-1);" + a + "_;" + list);
}

void run()
{
  work_in_own_directory();
  check_sweep();
  check_shared_packings();
  check_warnings();
  check_unbounded();
  check_results();
  check_inputs();
  check_packings();
  check_directories();
  check_both_ends();
  // From below collapses, then carries; from below carries, then collapses.
  check_long_lists();
  check_search({"Friction/Strength=0:10:1e-6"}, 0.5, "collapse", "solved");
  check_search({"Packing/wall/Height=1:10", "Rotations=true"}, 4., "solved",
               "collapse");

  fs::remove_all("output");
  run_scene({"--find", "Friction/Strength=2:10"});
  fs::remove_all("output");
  for (const char *wrong :
       {"Friction/Strength", "Friction/Strength=1:2", "Friction/Strength=1:2:1",
        "Friction/Strength=1:2:x", "Friction/Strength=0:2:3:log", "=1 | 2"})
    run_scene({"--sweep", wrong});
  run_scene({"--sweep", "Friction/Strength=1:2:1000", "--sweep",
             "Packing/wall/Height=1:2:1000"});
  for (const char *wrong : {"Friction/Strength=1", "Friction/Strength=2:1",
                            "Friction/Strength=1:2:2"})
    run_scene({"--find", wrong});
  run_scene({"--sweep", "Friction/Strength=-1:-1:2"});
  run_scene({"--sweep", "Friction/Strenght=1 | 2"});
  run_scene({"--sweep", "Friction/Strength=1 | 2", "--find",
             "Friction/Strength=1:2"});
  run_scene({"--sweep", "Friction/Strength=1 | 2", "--result", "/ground"});
  run_scene({"--result", "ground"});
  run_scene({"--directories"});
  check("nothing is written", !fs::exists("output"));
}

const RoomTest test("many_runs", run);
} // namespace test_many_runs
