// SPDX-License-Identifier: LGPL-2.1-or-later

// Load cases: how combinations are read; a combination of cases is the load
// that one section with the sums would be, on every cell and for blocks that
// turn; the program finds the cases of a file and of --set; and what is
// refused.

#include <voussoir/base/parameters/parameter_input.h>
#include <voussoir/scene/loads/load_cases.h>
#include <voussoir/scene/scene.h>

#include "own_directory.h"
#include "run_program.h"
#include "tests.h"
#include <filesystem>
#include <fstream>
#include <set>

namespace test_load_cases
{
using namespace Voussoir;
namespace fs = std::filesystem;

void show_combination(const std::string &combination)
{
  std::cout << '"' << combination << "\":";
  for (const CombinedCase &of : combination_of_text(combination, "here"))
    std::cout << ' ' << of.factor << " * '" << of.name << "'";
  std::cout << std::endl;
}

/** The scene with the loads of a section and of the cases in @p settings. */
Scene scene_of(const Packing<2> &packing, const std::string &settings)
{
  LoadParameters own;
  LoadCases cases;
  dealii::ParameterHandler prm;
  own.add_parameters(prm);
  cases.add_parameters(prm, {"dead", "lorry", "wind"});
  prm.parse_input_from_string(settings);
  Loads loads = own.loads(packing);
  cases.add_combination("Loads", packing, loads);
  return Scene(packing, std::vector<double>(packing.interfaces().size(), 1.),
               std::move(loads), rotations());
}

void same_as_sum()
{
  const Packing<2> packing = on_ground(wall(3, 3, 3., 2.));
  const Scene combined = scene_of(packing, R"(
    subsection Load cases
      subsection dead
        set Body force = 0; -20
      end
      subsection lorry
        set Cell forces = at 1.2, 1.9: 1, -10
        set Segment tractions = 0, 2 to 1, 2: 0, -4
      end
      subsection wind
        set Traction = 2*y; 0
        set Where = nx < -0.5
      end
    end
    subsection Loads
      set Combination = 1.35 dead + 1.5 lorry - wind
      set Body force = 1; 0
    end)");
  const Scene sum = scene_of(packing, R"(
    subsection Loads
      set Body force = 1; -27
      set Cell forces = at 1.2, 1.9: 1.5, -15
      set Segment tractions = 0, 2 to 1, 2: 0, -6
      set Traction = -2*y; 0
      set Where = nx < -0.5
    end)");
  double error = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    error = std::max({error, (combined.load[c] - sum.load[c]).norm(),
                      std::abs(combined.load_torque[c] - sum.load_torque[c])});
  check_error("a combination is the sum", error, 1e-13);
}

void run(const std::vector<std::string> &arguments)
{
  const auto [status, all, error] = run_program(arguments);
  std::cout << "status " << status << ' ' << error;
  for (std::size_t at = all.find("There are"); at != std::string::npos;
       at = all.find("There are", at + 1))
    std::cout << all.substr(at, all.find('\n', at) - at) << std::endl;
}

void in_the_program()
{
  work_in_own_directory();
  std::ofstream("scene.prm") << R"(
subsection Packing
  set Generator = wall
end
subsection Supports
  set Where = ny < -0.5
end
subsection Load cases   # of which a run takes some
  subsection dead
    set Body force = 0; -1
  end
end
)";
  std::ofstream("scene.json")
      << R"({"Load cases": {"dead": {"Body force": "0; -1"}, "axle": {}}})";
  check("the names in a .prm file",
        ParameterInput(fs::path("scene.prm")).sections_in("Load cases") ==
            std::set<std::string>{"dead"});
  check("the names in a .json file",
        ParameterInput(fs::path("scene.json")).sections_in("Load cases") ==
            std::set<std::string>{"axle", "dead"});
  run({"scene.prm", "--set", "Output/Files=none"});
  run({"scene.prm", "--set", "Output/Files=none", "--set",
       "Loads/Combination=dead"});
  run({"scene.prm", "--set", "Output/Files=none", "--set",
       "Loads/Combination=dead + push", "--set",
       "Load cases/push/Cell forces=at 0.1, 0.9: 0, -1"});
  run({"scene.prm", "--set", "Loads/Combination=dead + push"});
  run({"scene.prm", "--set", "Load cases/1st/Body force=0; 1"});
  run({"scene.prm", "--set", "Load cases/push/Bodyforce=0; 1"});
}

void run()
{
  for (const char *combination :
       {"", "dead", "1.35 dead + 1.5 lorry", "-dead", "2*dead-.5*wind",
        "1e-3 east + 2e3 west", "dead + dead", "1.5lorry"})
    show_combination(combination);
  for (const char *combination :
       {"1.35", "dead lorry", "dead +", "+ + dead", "1.2.3 dead", "1e999 dead",
        "dead, lorry", "2 3 dead"})
    show_refusal([&] { show_combination(combination); });
  const std::string letters(1000000, 'a'), blanks(1000000, ' ');
  check("long ones",
        combination_of_text("2" + blanks + letters, "here")[0].name == letters);
  same_as_sum();
  in_the_program();
}

const RoomTest test("load_cases", run);
} // namespace test_load_cases
