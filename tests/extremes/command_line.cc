// SPDX-License-Identifier: LGPL-2.1-or-later

// Whole runs at the extremes: the exit status is the right one, what fails says
// why in a sentence, and no .csv or .json file holds a number that is none.

#include <voussoir/run/command_line/command_line.h>

#include "own_directory.h"
#include "tests.h"
#include <filesystem>
#include <fstream>
#include <regex>

namespace test_command_line
{
namespace fs = std::filesystem;

/** The names of the files with a NaN or an infinity, or none. */
std::string bad_files()
{
  // JSON has null for a number that is none, and for a proof without friction.
  const std::regex bad("(^|[^a-z])(nan|inf|infinity|null)([^a-z]|$)",
                       std::regex::icase);
  std::string names;
  if (fs::exists("output"))
    for (const auto &file : fs::directory_iterator("output"))
    {
      // The others hold text of the user, or numbers in binary.
      const std::string extension = file.path().extension().string();
      if (extension != ".csv" && extension != ".json")
        continue;
      std::ifstream in(file.path());
      for (std::string line; std::getline(in, line);)
        if (std::regex_search(line, bad) &&
            line.find("\"work_over_dissipation\": null") == std::string::npos)
        {
          names += " " + file.path().filename().string();
          break;
        }
    }
  return names;
}

void run(const std::string &name, const std::string &settings, const int right)
{
  for (const Method &method : all_methods)
  {
    fs::remove_all("output");
    // Once with all that is computed from the forces.
    std::ofstream("scene.prm")
        << settings << "\nset Formulation = " << method.formulation
        << "\nset Accuracy = "
        << (method.name == least_energy.name ? "fine" : "draft")
        << "\nsubsection Solver\n subsection " << method.formulation << "\n  "
        << method.settings << "\n end\nend\n";
    std::ostringstream out, error;
    const int status = Voussoir::run_command_line({"scene.prm"}, out, error);
    const std::string message = error.str();
    check(name + ", " + method.name + ": status " + std::to_string(right) +
              (status == right
                   ? ""
                   : " but " + std::to_string(status) + " " + message),
          status == right);
    check(name + ", " + method.name + ": a sentence if it failed",
          status == 0 || (message.size() > 40 &&
                          message.substr(message.size() - 2) == ".\n"));
    check(name + ", " + method.name + ": no NaN" + bad_files(),
          bad_files().empty());
  }
}

std::string voronoi(const unsigned int n, const std::string &size)
{
  return "subsection Packing\n subsection Voronoi\n  set Number of points = " +
         std::to_string(n) + "\n  set Lower left = -" + size +
         ", 0\n"
         "  set Upper right = " +
         size + ", " + size + "\n end\nend\n";
}

std::string strength(const std::string &value)
{
  return "subsection Friction\n set Strength = " + value + "\nend\n";
}

std::string traction(const std::string &value)
{
  return "subsection Loads\n set Traction = " + value + "\nend\n";
}

void run()
{
  work_in_own_directory();

  const std::string pressure = traction("-nx; -ny");
  run("no friction", voronoi(30, "1") + strength("0") + pressure, 0);
  run("no friction, sheared",
      voronoi(30, "1") + strength("0") + traction("-1.5*nx; -0.5*ny"), 3);
  run("small",
      voronoi(30, "1e-9") + strength("1e-9") + traction("-1e-9*nx; -1e-9*ny"),
      0);
  run("large",
      voronoi(30, "1e9") + strength("1e12") + traction("-1e12*nx; -1e12*ny"),
      0);
  run("very strong",
      voronoi(30, "1") + strength("1e12") + traction("-1.3*nx; -0.7*ny"), 0);
  run("beyond all numbers when squared",
      voronoi(30, "1") + strength("1e300") + pressure, 0);
  run("strengths that jump",
      voronoi(30, "1") + strength("x < 0 ? 1e-6 : 1e6") + pressure, 0);
  run("one cell", voronoi(1, "1") + strength("1") + pressure, 0);
  run("no load", voronoi(30, "1") + strength("1") + traction("0; 0"), 0);
  const std::string wall = "subsection Packing\n set Generator = wall\nend\n";
  run("a wall at 1 - 1e-5 of the limit",
      wall + strength("1.00001") + traction("ny; 0"), 0);
  for (const char *beyond : {"0.9", "0.999999", "0.99999999"})
    run("a wall beyond the limit", wall + strength(beyond) + traction("ny; 0"),
        3);
}

const RoomTest test("command_line", run);
} // namespace test_command_line
