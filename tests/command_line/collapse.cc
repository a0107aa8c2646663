// SPDX-License-Identifier: LGPL-2.1-or-later

// A load that is not carried: the exit status, the message, and the files, from
// which the proof is computed again; they give way to the results of the next
// run in the same directory.

#include <voussoir/run/command_line/command_line.h>

#include <nlohmann/json.hpp>

#include "own_directory.h"
#include "table.h"
#include "tests.h"
#include <cmath>
#include <fstream>
#include <set>

namespace test_collapse
{
using namespace Voussoir;
namespace fs = std::filesystem;

void run(const std::string &strength, const std::string &formulation)
{
  std::ostringstream out, error;
  const int status =
      run_command_line({"scene.prm", "--set", "Friction/Strength=" + strength,
                        "--set", "Formulation=" + formulation},
                       out, error);
  std::cout << formulation << ", strength " << strength << ": exit status "
            << status << std::endl;
  if (!error.str().empty())
    std::cout << error.str();
  std::set<std::string> names;
  for (const auto &file : fs::directory_iterator("output"))
    names.insert(file.path().filename().string());
  for (const std::string &name : names)
    std::cout << "  " << name << std::endl;
}

void check_proof()
{
  double work = 0., dissipation = 0., closing = 0., largest = 0.;
  const Table cells = read_table("output/mechanism.csv");
  const std::vector<double> &ux = cells.at("ux"), &uy = cells.at("uy");
  for (unsigned int c = 0; c < ux.size(); ++c)
  {
    work += cells.at("load_x")[c] * ux[c] + cells.at("load_y")[c] * uy[c];
    largest = std::max({largest, std::abs(ux[c]), std::abs(uy[c])});
  }
  double inconsistency = 0.;
  const Table joints = read_table("output/mechanism_joints.csv");
  for (unsigned int e = 0; e < joints.at("nx").size(); ++e)
  {
    const auto of = [&](const std::string &name) { return joints.at(name)[e]; };
    const unsigned int minus = of("cell_minus"), plus = of("cell_plus");
    const double x = ux[plus] - ux[minus], y = uy[plus] - uy[minus];
    const double opening = x * of("nx") + y * of("ny");
    const double sliding = -x * of("ny") + y * of("nx");
    inconsistency = std::max({inconsistency, std::abs(opening - of("opening")),
                              std::abs(sliding - of("sliding"))});
    closing = std::max(closing, -opening);
    dissipation += of("strength") * of("length") * std::abs(sliding);
  }
  check_error("  jumps against displacements", inconsistency, 1e-15);
  check_error("  closing of joints", closing, 1e-14);
  check_error("  largest displacement less one", std::abs(largest - 1.), 1e-15);

  nlohmann::json summary;
  std::ifstream("output/summary.json") >> summary;
  const auto &mechanism = summary["mechanism"];
  check("  status collapse", summary["status"] == "collapse");
  check_error("  ratio of work to dissipation against the summary",
              std::abs(work / dissipation -
                       mechanism["work_over_dissipation"].get<double>()),
              1e-12);
  double parts = 0.;
  for (const auto &part : mechanism["work_of_loads"])
    parts += part["work"].get<double>();
  check_error("  work of the parts against that of all", std::abs(parts - work),
              1e-12);
}

void run()
{
  work_in_own_directory();
  std::ofstream("scene.prm")
      << "subsection Packing\n set Generator = wall\nend\n"
         "subsection Loads\n set Traction = ny; 0\nend\n";

  for (const std::string formulation : {"smoothed friction", "linear program",
                                        "least energy", "analytic centre"})
  {
    run("0.9", formulation);
    check_proof();
  }
  // A mistake of units is likely.
  run("0.05", "least energy");
  check_proof();
  // Dead loads that need the live ones have factors, unless those do no work in
  // the collapse.
  for (const std::string live : {"-ny; 0", "-nx; -ny"})
  {
    std::ostringstream out, error;
    const int status = run_command_line(
        {"scene.prm", "--set", "Friction/Strength=0.9", "--set",
         "Analysis=load factor", "--set", "Live loads/Traction=" + live},
        out, error);
    std::cout << "a factor of " << live
              << " beside dead loads that collapse: exit status " << status
              << std::endl
              << error.str();
    nlohmann::json summary;
    std::ifstream("output/summary.json") >> summary;
    if (status == 0)
    {
      const nlohmann::json &factor = summary["load_factor"];
      // Stresses of 0.1 to 1.9 balance those of one within 0.9, and none else.
      check_error("  the greatest factor",
                  factor["carried"].get<double>() - 1.9, 1e-7);
      std::cout << "  "
                << factor["meaning"].get<std::string>().substr(
                       factor["meaning"].get<std::string>().find("; the dead"))
                << std::endl;
      continue;
    }
    check_proof();
    check("  of the dead loads",
          summary["mechanism"]["loads"] == "dead, with any factor");
  }
  run("10", "analytic centre");
  const Table interfaces = read_table("output/interfaces.csv");
  bool right = true;
  for (unsigned int e = 0; e < interfaces.at("ny").size(); ++e)
    right &= (std::abs(interfaces.at("ny")[e]) > 0.5) ==
             (interfaces.at("never_pressed")[e] == 1.);
  check("the bed joints are marked as never pressed", right);
}

const RoomTest test("collapse", run);
} // namespace test_collapse
