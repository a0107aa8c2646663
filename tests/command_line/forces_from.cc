// SPDX-License-Identifier: LGPL-2.1-or-later

// Forces that an earlier run has found, used again: what follows from them is
// the same to the last byte as in one run, they are not lost from a directory
// that is written to again, and whatever is not of the same packing is refused
// with file, line, both values, and nothing written.

#include <boost/algorithm/string.hpp>
#include <nlohmann/json.hpp>

#include "own_directory.h"
#include "run_program.h"
#include "tests.h"
#include <filesystem>
#include <fstream>
#include <set>

namespace test_forces_from
{
namespace fs = std::filesystem;

nlohmann::json read_summary(const std::string &directory)
{
  return nlohmann::json::parse(content_of(directory + "/summary.json"));
}

std::set<std::string> names_in(const std::string &directory)
{
  std::set<std::string> names;
  if (fs::exists(directory))
    for (const auto &file : fs::directory_iterator(directory))
      names.insert(file.path().filename());
  return names;
}

/** Run a scene with the settings "Section/Name=value | ...". */
Ended run(const std::string &scene, const std::string &settings)
{
  std::vector<std::string> words = {scene}, assignments;
  boost::split(assignments, settings, boost::is_any_of("|"));
  for (const std::string &assignment : assignments)
    words.insert(words.end(), {"--set", boost::trim_copy(assignment)});
  return run_program(words);
}

/** As run(), and the status must be 0. */
Ended solve(const std::string &scene, const std::string &settings)
{
  const Ended result = run(scene, settings);
  if (result.status != 0)
    std::cout << "FAILED: " << result.error;
  return result;
}

/** Two runs against one. */
void round_trip(const std::string &scene, const std::string &formulation)
{
  std::cout << formulation << ", " << scene << std::endl;
  const std::string way = "Formulation=" + formulation;
  solve(scene, way + " | Output directory=first | Output/Files=csv | "
                     "Accuracy=draft");
  const Ended second =
      solve(scene, "Forces from=first | Output directory=second | "
                   "Accuracy=fine | Title=again");
  solve(scene, way + " | Output directory=single | Accuracy=fine");

  for (const char *file :
       {"interfaces.csv", "cells.csv", "interfaces.vtu", "stress.vtu"})
    check(std::string("  ") + file + " as by a single run",
          !content_of(std::string("single/") + file).empty() &&
              content_of(std::string("second/") + file) ==
                  content_of(std::string("single/") + file));
  check("  the terminal says so",
        second.out.find("Statics        " + formulation +
                        ": read from 'first'\n") != std::string::npos &&
            second.out.find("Forces         read from 'first'\n") !=
                std::string::npos);

  auto summary = read_summary("second"), single = read_summary("single");
  check("  the summary says so",
        summary["solver"]["outcome"] == "read from 'first'" &&
            summary["solver"]["earlier_outcome"] == "converged");
  check("  the title is of this run", summary["title"] == "again");
  for (nlohmann::json *json : {&summary, &single})
  {
    json->erase("title");
    json->erase("timings");
    json->erase("provenance");
    (*json)["solver"].erase("seconds");
    (*json)["solver"].erase("outcome");
    (*json)["solver"].erase("earlier_outcome");
  }
  check("  the summary has all else of a single run", summary == single);
}

/** The directory of the forces may be that of the results. */
void same_directory(const std::string &scene)
{
  std::cout << "In the same directory" << std::endl;
  solve(scene, "Output directory=first | Output/Files=csv | Accuracy=draft");
  const std::string interfaces = content_of("first/interfaces.csv"),
                    cells = content_of("first/cells.csv");
  for (const char *files : {"vtu", "none"})
  {
    solve(scene, std::string("Output directory=./first | Forces from=first | "
                             "Output/Files=") +
                     files);
    check(std::string("  the forces stay with Files = ") + files,
          content_of("first/interfaces.csv") == interfaces &&
              content_of("first/cells.csv") == cells);
    check("  stress.vtu is written if it is wanted",
          names_in("first").count("stress.vtu") == (files[0] == 'v'));
  }
  check("  who found them is known after the second time",
        read_summary("first")["solver"]["earlier_outcome"] == "converged");
}

void equilibrated(const std::string &scene)
{
  std::cout << "Equilibrated later" << std::endl;
  const std::string loose = "Formulation=smoothed friction | "
                            "Solver/Tolerance=1e-2 | Accuracy=draft | ";
  solve(scene, loose + "Output directory=first");
  solve(scene, loose + "Output directory=second | Forces from=first | "
                       "Solver/Equilibrate=true");
  const auto residual = [](const std::string &directory) {
    return read_summary(directory)["certificate"]["equilibrium_residual"]
        .get<double>();
  };
  check("  there was something to correct", residual("first") > 1e-9);
  check_error("  residual", residual("second"), 1e-12);
  check("  by a correction that is named",
        read_summary("second")["solver"].contains("correction"));
  solve(scene, loose + "Output directory=third | Forces from=second | "
                       "Solver/Equilibrate=true");
  check("  and left as they are the next time",
        content_of("third/interfaces.csv") ==
            content_of("second/interfaces.csv"));
}

void unconverged(const std::string &scene)
{
  std::cout << "Not converged" << std::endl;
  solve(scene, "Output directory=first | Accuracy=draft");
  auto summary = read_summary("first");
  summary["solver"]["outcome"] = "stopped at the limit of rounding";
  std::ofstream("first/summary.json") << summary;
  std::istringstream out(solve(scene,
                               "Forces from=first | Output directory=second | "
                               "Accuracy=draft | Output/Verbosity=0")
                             .out);
  for (std::string line; std::getline(out, line);)
    if (line.find("Warning") == 0 || line.find("Forces") == 0)
      std::cout << line << std::endl;
}

/** Replace in line @p number (from 1) of a file; @p change gets the fields. */
void edit(const std::string &file,
          const unsigned int number,
          const std::function<void(std::vector<std::string> &)> &change)
{
  std::vector<std::string> lines, fields;
  const std::string content = content_of(file);
  boost::split(lines, content, boost::is_any_of("\n"));
  boost::split(fields, lines.at(number - 1), boost::is_any_of(","));
  change(fields);
  lines[number - 1] = boost::join(fields, ",");
  std::ofstream(file) << boost::join(lines, "\n");
}

/** Set one field. */
void edit(const std::string &file,
          const unsigned int number,
          const unsigned int field,
          const std::string &value)
{
  edit(file, number, [&](auto &fields) { fields.at(field) = value; });
}

/** Use forces from a copy of "good" that @p spoil was done to. */
void refused(const std::string &scene,
             const std::function<void()> &spoil,
             const std::string &settings = "Output/Verbosity=0")
{
  fs::remove_all("bad");
  fs::remove_all("output");
  fs::copy("good", "bad");
  spoil();
  const Ended result = run(scene, "Forces from=bad | " + settings);
  std::cout << "status " << result.status
            << (fs::exists("output") ? " FAILED: files " : " ") << result.error;
}

void failures(const std::string &scene)
{
  std::cout << "Refused" << std::endl;
  solve(scene, "Output directory=good | Accuracy=draft");
  const auto nothing = [] {};
  const std::string interfaces = "bad/interfaces.csv", cells = "bad/cells.csv";

  // Not there
  refused(scene, [] { fs::remove_all("bad"); });
  refused(scene, [] { fs::remove("bad/summary.json"); });
  refused(scene, [&] { fs::remove(interfaces); });
  refused(scene, [&] { fs::remove(cells); });
  refused(scene, [&] {
    fs::remove(cells);
    fs::create_directory(cells);
  });
  refused(scene, [] { std::ofstream("bad/summary.json") << "{}\n"; });
  refused(scene, [] { std::ofstream("bad/summary.json") << "{ \"a\""; });
  for (const char *const no_count : {"1e300", "-1", "2.5", "\"12\""})
    refused(scene, [&] {
      auto summary = read_summary("bad");
      summary["packing"]["cells"] = nlohmann::json::parse(no_count);
      std::ofstream("bad/summary.json") << summary;
    });
  refused(scene, [&] {
    run(scene,
        "Output directory=bad | Loads/Traction=ny; 0 | Friction/Strength=0.5");
  });

  // Not as it was written
  refused(scene, [&] { edit(interfaces, 1, 9, "force"); });
  refused(scene, [&] { edit(cells, 1, 6, ""); });
  refused(scene, [&] { std::ofstream(interfaces).flush(); });
  refused(scene, [&] { edit(interfaces, 4, 9, "1.5e"); });
  refused(scene, [&] { edit(interfaces, 4, 10, "nan"); });
  refused(scene, [&] { edit(interfaces, 4, 10, std::string(100, '1') + "x"); });
  refused(scene,
          [&] { edit(interfaces, 5, [](auto &fields) { fields.resize(3); }); });
  refused(scene, [&] { // after ten fields of the fourth line
    const std::string all = content_of(interfaces);
    std::size_t end = 0;
    for (const char c : std::string("\n\n\n,,,,,,,,,,"))
      end = all.find(c, end) + 1;
    fs::resize_file(interfaces, end - 1);
  });
  refused(scene, [&] { std::ofstream(cells, std::ios::app) << "4,0\n"; });
  refused(scene, [&] {
    std::ofstream(interfaces, std::ios::app)
        << "0,1,0,0,1,1,1,1,1,1,1,1,1,1,1\n";
  });
  refused(scene, [&] {
    const std::string all = content_of(cells);
    std::ofstream(cells) << all.substr(0, all.rfind('\n', all.size() - 2) + 1);
  });

  // Not the same
  refused(scene, nothing, "Packing/wall/Courses=3");
  refused(scene, nothing, "Supports/Where=y < 1e-9");
  refused(scene, [&] { edit(interfaces, 3, 1, "4"); });
  refused(scene, [&] { edit(interfaces, 3, 1, "-1"); });
  refused(scene, nothing, "Packing/wall/Width=2");
  refused(scene, [&] { edit(interfaces, 2, 4, "0.5000000003"); });
  refused(scene, nothing, "Friction/Strength=3");
  refused(scene, [&] { edit(cells, 3, 2, "0.125"); });
  refused(scene, [&] { edit(cells, 3, 0, "7"); });
  refused(scene, nothing, "Loads/Traction=-nx; -1.5*ny");
  refused(scene, [&] { edit(interfaces, 3, 10, "0.5"); });
}

void run()
{
  work_in_own_directory();
  std::ofstream("voronoi.prm")
      << "subsection Packing\n subsection Voronoi\n"
         "  set Number of points = 60\n end\nend\n"
         "subsection Loads\n set Traction = -1.2*nx; -0.8*ny\nend\n"
         "subsection Friction\n set Strength = 0.3 + 0.1*y\nend\n";
  std::ofstream("arch.prm")
      << "subsection Packing\n set Generator = arch\nend\n"
         "subsection Supports\n set Where = y < 1e-9\nend\n"
         "subsection Loads\n set Body force = 0; -1\nend\n";
  std::ofstream("shear.prm")
      << "subsection Packing\n set Generator = wall\nend\n"
         "subsection Loads\n set Traction = ny; 0\nend\n"
         "subsection Friction\n set Strength = 10\nend\n";
  std::ofstream("wall.prm")
      << "subsection Packing\n set Generator = wall\n subsection wall\n"
         "  set Courses = 2\n  set Bricks per course = 2\n end\nend\n"
         "subsection Loads\n set Traction = -nx; -0.5*ny\nend\n"
         "subsection Friction\n set Strength = 2\nend\n";

  round_trip("voronoi.prm", "least energy");
  round_trip("voronoi.prm", "smoothed friction");
  round_trip("arch.prm", "least energy");
  round_trip("shear.prm", "analytic centre");
  same_directory("voronoi.prm");
  equilibrated("voronoi.prm");
  unconverged("voronoi.prm");
  failures("wall.prm");

  // Other line ends, and other columns in another order, are no fault.
  fs::remove_all("bad");
  fs::copy("good", "bad");
  const std::string all = content_of("good/cells.csv");
  std::ofstream("bad/cells.csv") << boost::replace_all_copy(all, "\n", "\r\n");
  for (unsigned int line = 1; line <= 8; ++line)
    edit("bad/interfaces.csv", line,
         [](auto &fields) { std::swap(fields[8], fields[9]); });
  solve("wall.prm",
        "Forces from=bad | Output directory=second | Accuracy=draft");
  check("line ends and the order of columns do not matter",
        content_of("second/interfaces.csv") ==
                content_of("good/interfaces.csv") &&
            content_of("second/cells.csv") == all);
}

const RoomTest test("forces_from", run);
} // namespace test_forces_from
