// SPDX-License-Identifier: LGPL-2.1-or-later

// --validate says what was understood of a scene, refuses what a run would
// refuse, and writes nothing.

#include "own_directory.h"
#include "run_program.h"
#include "tests.h"
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace test_validate
{
namespace fs = std::filesystem;

std::string run_with(std::vector<std::string> words)
{
  words.emplace_back("--validate");
  const Ended ended = run_program(words);
  return ended.out + (ended.status == 0 ? "" : ended.message());
}

void run()
{
  work_in_own_directory();

  // Two materials on the ground: 2 x 1 of weight 3 a square, 2 x 0.5 of 1.
  std::ofstream("scene.prm") << R"(
set Rotations = true
subsection Packing
  set Generator = wall
  set Groups = upper: y > 1
  subsection wall
    set Width = 2
    set Height = 1.5
    set Courses = 3
    set Bricks per course = 2
  end
end
subsection Supports
  set Where = ny < -0.5
end
subsection Loads
  set Boundary load = traction
  set Traction = ny > 0.5 ? -0.25 : 0; 0
  set Group body forces = brick: 0; -3 | upper: 0; -1
end
subsection Live loads
  set Traction = 0; ny > 0.5 ? -1 : 0
end
subsection Friction
  set Law = Coulomb
  set Cohesion = 0.1
  set Coefficient = abs(ny) > 0.5 ? 0.7 : 0.5
end
subsection Contact
  set Tensile strength = 0
  set Compressive strength = 50
end
subsection Units
  set Length = m
  set Stress = kPa
  set Force = kN/m
end
)";
  std::cout << run_with({"scene.prm"})
            << run_with({"scene.prm", "--set", "Analysis=load factor"});
  // Stages are what it shows, whatever the verbosity.
  check("at any verbosity",
        run_with({"scene.prm", "--verbosity", "0"}) == run_with({"scene.prm"}));
  check("quiet", run_with({"scene.prm", "--quiet"}).empty());
  check("nothing is written", std::distance(fs::directory_iterator("."),
                                            fs::directory_iterator()) == 1);

  // What a run would refuse.
  std::cout << run_with({"scene.prm", "--set", "Supports/Where="})
            << run_with({"scene.prm", "--set", "Friction/Cohesion=-1"})
            << run_with({"scene.prm", "--set", "Packing/Groups=a: x > 9"})
            << run_with({"scene.prm", "--set", "Ranges/Where=x > 9"})
            << run_with({"scene.prm", "--sweep", "Friction/Cohesion=1:2:3"})
            << run_with({});

  // Many groups are not all shown.
  std::string groups;
  for (int k = 0; k < 40; ++k)
    groups += Voussoir::text(k > 0 ? "; " : "", "g", k, ": x > ", k, " && x < ",
                             k + 1);
  std::cout << run_with(
      {"--set", "Packing/Generator=wall", "--set", "Packing/wall/Width=40",
       "--set", "Packing/wall/Courses=1", "--set",
       "Packing/wall/Bricks per course=40", "--set", "Packing/Groups=" + groups,
       "--set", "Loads/Group body forces=", "scene.prm"});

  std::string refused;
  for (const auto &file : fs::directory_iterator(SOURCE_DIR "/../../prm"))
    // A million cells take half a minute in Debug.
    if (file.path().extension() == ".prm" &&
        file.path().stem() != "million_cells")
      if (const std::string words = run_with({file.path()});
          words.find("Valid ") == std::string::npos)
        refused += ' ' + words;
  check("the scenes of prm/ are valid" + refused, refused.empty());
  check("and nothing is written for them",
        std::distance(fs::directory_iterator("."), fs::directory_iterator()) ==
            1);
}

const RoomTest test("validate", run);
} // namespace test_validate
