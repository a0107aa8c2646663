// SPDX-License-Identifier: LGPL-2.1-or-later

// A load that is not carried: the exit status, the message, and the files, from
// which the proof is computed again; they give way to the results of the next
// run in the same directory.

#include <voussoir/command_line.h>

#include <boost/algorithm/string.hpp>
#include <nlohmann/json.hpp>

#include "tests.h"
#include <cmath>
#include <fstream>
#include <set>

using namespace Voussoir;
namespace fs = std::filesystem;

/** The rows of a .csv file, by the names of the columns. */
std::vector<std::map<std::string, double>> read(const std::string &file)
{
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  std::vector<std::string> names, words;
  boost::split(names, line, boost::is_any_of(","));
  std::vector<std::map<std::string, double>> rows;
  while (std::getline(in, line))
  {
    boost::split(words, line, boost::is_any_of(","));
    rows.emplace_back();
    for (unsigned int i = 0; i < names.size(); ++i)
      rows.back()[names[i]] = std::stod(words.at(i));
  }
  return rows;
}

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
  const auto cells = read("output/mechanism.csv");
  for (auto cell : cells)
  {
    work += cell["load_x"] * cell["ux"] + cell["load_y"] * cell["uy"];
    largest = std::max({largest, std::abs(cell["ux"]), std::abs(cell["uy"])});
  }
  double inconsistency = 0.;
  for (auto joint : read("output/mechanism_joints.csv"))
  {
    auto minus = cells.at(joint["cell_minus"]);
    auto plus = cells.at(joint["cell_plus"]);
    const double x = plus["ux"] - minus["ux"], y = plus["uy"] - minus["uy"];
    const double opening = x * joint["nx"] + y * joint["ny"];
    const double sliding = -x * joint["ny"] + y * joint["nx"];
    inconsistency =
        std::max({inconsistency, std::abs(opening - joint["opening"]),
                  std::abs(sliding - joint["sliding"])});
    closing = std::max(closing, -opening);
    dissipation += joint["strength"] * joint["length"] * std::abs(sliding);
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

int main()
{
  // In a directory of its own: the runner of the tests uses the name "output".
  fs::remove_all("run");
  fs::create_directory("run");
  fs::current_path("run");
  std::ofstream("scene.prm")
      << "subsection Packing\n set Generator = running bond\nend\n"
         "subsection Loads\n set Traction = ny; 0\nend\n";

  for (const std::string formulation : {"smoothed friction", "linear program",
                                        "least energy", "analytic centre"})
  {
    run("0.9", formulation);
    check_proof();
  }
  run("10", "analytic centre");
  for (const auto &row : read("output/interfaces.csv"))
    if ((std::abs(row.at("ny")) > 0.5) != (row.at("never_pressed") == 1.))
      std::cout << "FAILED: a joint is not marked as it should be\n";
}
