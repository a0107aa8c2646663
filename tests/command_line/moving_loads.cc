// SPDX-License-Identifier: LGPL-2.1-or-later

// Moving loads: the factor of an axle on a beam that may tilt is known at each
// position; the runs of a sweep are those alone; and the run of the least
// factor is written, with its mechanism, and the way to it is on the page.

#include <boost/algorithm/string.hpp>
#include <nlohmann/json.hpp>

#include "own_directory.h"
#include "run_program.h"
#include "tests.h"
#include <filesystem>
#include <fstream>

namespace test_moving_loads
{
namespace fs = std::filesystem;

// A beam of length 4 and weight 8 on a pier of width 1 between -1/2 and 1/2: an
// axle at x > 1/2 turns it over by its end if it is 4 / (x - 1/2).
void write_scene()
{
  std::ofstream("beam.wkt")
      << "POLYGON ((-0.5 0, 0.5 0, 0.5 1, -0.5 1, -0.5 0))\n"
         "POLYGON ((-2 1, 2 1, 2 2, -2 2, -2 1))\n";
  std::ofstream("scene.prm") << "set Analysis = load factor\n"
                                "set Rotations = true\n"
                                "subsection Packing\n"
                                "  set Generator = polygons\n"
                                "  subsection polygons\n"
                                "    set File = beam.wkt\n"
                                "  end\n"
                                "end\n"
                                "subsection Supports\n"
                                "  set Where = y < 1e-9\n"
                                "end\n"
                                "subsection Friction\n"
                                "  set Strength = 100\n"
                                "end\n"
                                "subsection Loads\n"
                                "  set Body force = 0; -2\n"
                                "end\n"
                                "subsection Live loads\n"
                                "  subsection Vehicle\n"
                                "    set Axles = 0: 2 | 10: 7\n"
                                "    set Effective width = 2\n"
                                "    set Position = 1\n"
                                "  end\n"
                                "end\n";
}

const std::string position = "Live loads/Vehicle/Position";

std::vector<std::vector<std::string>> table()
{
  std::ifstream in("output/sweep.csv");
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);)
  {
    rows.emplace_back();
    boost::split(rows.back(), line, boost::is_any_of(","));
  }
  return rows;
}

nlohmann::json summary_in(const std::string &directory)
{
  return nlohmann::json::parse(content_of(directory + "/summary.json"));
}

bool has(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

void check_beam()
{
  const Ended ended = run_program(
      {"scene.prm", "--sweep", position + "=-1.9:1.9:39", "--critical"});
  check("the status", ended.status == 0);
  const auto rows = table();
  check("a line for each position", rows.size() == 40);
  double error = 0.;
  bool are_unbounded = true;
  for (std::size_t k = 1; k < rows.size(); ++k)
  {
    const double arm = std::abs(std::stod(rows[k][0])) - 0.5;
    const std::string &factor = rows[k][2];
    if (arm > 1e-9)
      error = std::max(error, std::abs(std::stod(factor) * arm / 4. - 1.));
    else if (arm < -1e-9)
      are_unbounded = are_unbounded && factor == "inf";
  }
  check_error("each factor", error, 1e-8);
  check("on the pier there is none", are_unbounded);
  check("the least and the greatest are said",
        has(ended.out,
            "Load factor    from 2.85714 with " + position + " = -1.9 to "));
  check("so are the axles beside",
        has(ended.out, "In all runs: An axle of 'Live loads/Vehicle' stands "
                       "beside the blocks, and loads none."));
  const auto critical = summary_in("output/critical");
  check_error("the run of the least",
              critical.at("load_factor").at("carried").get<double>() - 4. / 1.4,
              1e-8);
  check("with its mechanism", fs::exists("output/critical/mechanism.csv"));
  check("to which the page leads", has(content_of("output/sweep.html"),
                                       "<a href=\"critical/report.html\">"));
}

/** Each run of a bridge is the one alone. */
void check_alone()
{
  const std::string bridge = SOURCE_DIR "/../../prm/bridge_with_lorry.prm";
  const std::string lorry = position + "=-4.5:3:6";
  run_program({bridge, "--set", "Output directory=output", "--sweep", lorry,
               "--directories", "--result", "load_factor/bound"});
  bool are_alike = true;
  const auto rows = table();
  check("runs", rows.size() == 7);
  for (std::size_t k = 1; k < rows.size(); ++k)
  {
    run_program({bridge, "--set", "Output directory=alone", "--set",
                 position + '=' + rows[k][0]});
    const std::string of_run = "output/run_" + std::to_string(k);
    are_alike =
        are_alike &&
        content_of(of_run + "/interfaces.csv") ==
            content_of("alone/interfaces.csv") &&
        summary_in(of_run).at("load_factor") ==
            summary_in("alone").at("load_factor") &&
        std::stod(rows[k][2]) ==
            summary_in("alone").at("load_factor").at("carried").get<double>();
    check("the page leads to it",
          has(content_of("output/sweep.html"),
              "<a href=\"run_" + std::to_string(k) + "/report.html\">"));
  }
  check("each run is the one alone", are_alike);
}

void check_faults()
{
  fs::remove_all("output");
  std::cout << run_program({"scene.prm", "--critical"}).message();
  std::cout << run_program(
                   {"scene.prm", "--find", position + "=0:1.9", "--critical"})
                   .message();
  check("nothing is written", !fs::exists("output"));
  std::cout << run_program({"scene.prm", "--set", "Analysis=state", "--sweep",
                            "Friction/Strength=50 | 100", "--critical"})
                   .message();
  std::cout << run_program({"scene.prm", "--set", position + "=-30"}).message();
}

void run()
{
  work_in_own_directory();
  write_scene();
  check_beam();
  check_alone();
  check_faults();
}

const RoomTest test("moving_loads", run);
} // namespace test_moving_loads
