// SPDX-License-Identifier: LGPL-2.1-or-later

// Variables: a scene with names in it is the scene with their numbers, also in
// JSON, in sweeps and in searches, whose results are known; and what is wrong
// is said with its place.

#include "own_directory.h"
#include "run_scene.h"
#include "table.h"
#include "tests.h"
#include <filesystem>
#include <fstream>

namespace test_variables
{
namespace fs = std::filesystem;

// A block of width b and height h, of weight 1 a unit of area, that is pushed
// by a force of 4 at the height y turns over if 4 y > h b^2 / 2.
const char *scene = "set Title = $$ and $5\n"
                    "set Rotations = true\n"
                    "set Formulation = least energy\n"
                    "subsection Variables\n"
                    "  set b = 2 # the width\n"
                    "  set h = 2 * b\n"
                    "  set y = h / 8\n"
                    "  set n = 1e1 / 10\n"
                    "end\n"
                    "subsection Packing\n"
                    "  set Generator = wall\n"
                    "  subsection wall\n"
                    "    set Courses           = $n # $none\n"
                    "    set Bricks per course = $n\n"
                    "    set Width             = $b\n"
                    "    set Height            = $(b + min(b, h) * n)\n"
                    "  end\n"
                    "end\n"
                    "subsection Supports\n"
                    "  set Where = y < 1e-9 * $h\n"
                    "end\n"
                    "subsection Friction\n"
                    "  set Strength = 10\n"
                    "end\n"
                    "subsection Loads\n"
                    "  set Body force   = 0; -1\n"
                    "  set Cell forces  = at 0.1, $y: 4, 0\n"
                    "end\n";

SceneRunner run_scene(scene);

std::string content(const std::string &file)
{
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string settings(const std::vector<std::string> &more)
{
  std::vector<std::string> words = {"--print-settings"};
  words.insert(words.end(), more.begin(), more.end());
  check("settings are printed", run_scene(words) == 0);
  return run_scene.last_output;
}

bool has(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

void check_numbers()
{
  const std::string numbers = settings({});
  for (const char *line :
       {"set Title       = $ and $5\n", "    set Courses           = 1\n",
        "    set Width             = 2\n", "    set Height            = 4\n",
        "  set Where = y < 1e-9 * 4\n",
        "  set Cell forces = at 0.1, 0.5: 4, 0\n"})
    check("with a number", has(numbers, line));
  const std::string wide = settings({"--set", "Variables/b=3"});
  check("those behind follow",
        has(wide, "Height            = 6\n") &&
            has(wide, "Cell forces = at 0.1, 0.75: 4, 0\n"));
  check("one of --set's own",
        has(settings({"--set", "Loads/Body force=0; -$(w^2)", "--set",
                      "Variables/w=n / 4"}),
            "Body force  = 0; -0.0625\n"));
  check("signs have parentheses where they need them",
        has(settings({"--set", "Loads/Body force=$w ^2-$w; -$w + $w", "--set",
                      "Variables/w=-n"}),
            "Body force  = (-1) ^2-(-1); -(-1) + (-1)\n"));
}

/** The same forces as with the numbers, and from JSON. */
void check_forces()
{
  check("a run", run_scene({}) == 0);
  check("that says what the numbers are",
        has(run_scene.last_output, "Variables      b = 2, h = 4, y = 0.5, n = "
                                   "1\n"));
  const std::string forces = content("output/interfaces.csv");
  check("the parameters beside the results have both",
        has(content("output/parameters.prm"), "  set h = 2 * b\n"));
  const char *const words[] = {"prm", "json", "xml"};
  for (const std::string format : words)
  {
    run_scene({"--print-settings", "--as", format});
    std::ofstream("numbers." + format) << run_scene.last_output;
    check("with numbers",
          run_program({"numbers." + format, "--set", "Output directory=alike"})
                  .status == 0);
    check("the same forces", content("alike/interfaces.csv") == forces);
  }
  std::ofstream("names.json") << R"json({
    "Rotations": true, "Formulation": "least energy",
    "Variables": {"b": 2, "h": {"value": "2 * b"}},
    "Packing": {"Generator": "wall",
      "wall": {"Courses": "$(b / 2)", "Bricks per course": 1,
               "Width": {"value": "$b"}, "Height": "$h"}},
    "Supports": {"Where": "y < 1e-9"}, "Friction": {"Strength": 10},
    "Loads": {"Body force": "0; -1",
              "Cell forces": "at 0.1, $(h / 8): 4, 0"}})json";
  check("names in JSON",
        run_program({"names.json", "--set", "Output directory=alike"}).status ==
            0);
  check("the same forces", content("alike/interfaces.csv") == forces);
}

void check_many()
{
  check("a search", run_scene({"--find", "Variables/y=1:3.5:1e-7"}) == 0);
  std::ifstream in("output/sweep.csv");
  double low = 0., high = 4.;
  std::string line;
  for (std::getline(in, line); std::getline(in, line);)
    (has(line, ",solved,") ? low : high) =
        has(line, ",solved,") ? std::max(low, std::stod(line))
                              : std::min(high, std::stod(line));
  check_error("the limit", low - 2., 1e-6);
  check_error("the limit", high - 2., 1e-6);
}

void check_faults()
{
  const auto fault = [](const std::vector<std::string> &assignments) {
    std::vector<std::string> words;
    for (const std::string &assignment : assignments)
      words.insert(words.end(), {"--set", assignment});
    fs::remove_all("output");
    check("is refused", run_scene(words) == 2);
    check("nothing is written", !fs::exists("output"));
  };
  fault({"Variables/b=h"});
  fault({"Variables/h=2 *"});
  fault({"Variables/h=1/0"});
  fault({"Variables/h=sqrt(-b)"});
  fault({"Variables/pi=3"});
  fault({"Variables/sin=3"});
  fault({"Variables/2b=3"});
  fault({"Packing/wall/Width=$width"});
  fault({"Packing/wall/Width=$(2 * width)"});
  fault({"Packing/wall/Width=$(b + (1)"});
  fault({"Packing/wall/Width=$(log(0))"});
  fault({"Packing/wall/Courses=$(b / 4)"});
  std::ofstream("without.prm") << "set Title = a\nset Title = $b\n";
  std::cout << run_program({"without.prm"}).message();
  std::ofstream("without.json") << R"({"Packing": {"wall": {"Width": "$b"}}})";
  std::cout << run_program({"without.json"}).message();
  check("what nothing uses is said",
        run_scene({"--set", "Variables/k=b", "--validate"}) == 0 &&
            has(run_scene.last_output,
                "'Variables/k' has no effect, since no value has $k."));
}

void run()
{
  work_in_own_directory();
  check_numbers();
  check_forces();
  check_many();
  check_faults();
}

const RoomTest test("variables", run);
} // namespace test_variables
