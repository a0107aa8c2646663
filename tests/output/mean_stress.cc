// SPDX-License-Identifier: LGPL-2.1-or-later

// The forces and branch vectors of interfaces.csv and boundary.csv add up to
// the mean stress of the packing: the applied one where that is uniform, and
// the mean over the cells where the tractions vary along the sides.

#include <voussoir/run/command_line/command_line.h>

#include "own_directory.h"
#include "table.h"
#include "tests.h"
#include <array>

namespace test_mean_stress
{
using namespace Voussoir;

using Stress = std::array<double, 4>;

const std::string packing = "subsection Packing\n subsection Voronoi\n"
                            "  set Number of points = 60\n end\nend\n"
                            "subsection Friction\n set Strength = 5\nend\n";

void solve(const std::string &loads)
{
  std::ofstream("scene.prm") << packing << loads;
  std::ostringstream out, error;
  check("solved", run_command_line({"scene.prm", "--set", "Output/Files=csv"},
                                   out, error) == 0);
}

/** The sum over interfaces and boundary edges, over the area. */
Stress summed()
{
  Table e = read_table("output/interfaces.csv");
  Table b = read_table("output/boundary.csv");
  Table c = read_table("output/cells.csv");
  Stress sum = {};
  const auto add = [&](const double fx, const double fy, const double x,
                       const double y) {
    sum[0] += fx * x;
    sum[1] += fx * y;
    sum[2] += fy * x;
    sum[3] += fy * y;
  };
  for (unsigned int k = 0; k < e["nx"].size(); ++k)
  {
    const double n = e["normal_force"][k], t = e["tangential_force"][k];
    const double nx = e["nx"][k], ny = e["ny"][k];
    add(n * nx - t * ny, n * ny + t * nx, e["branch_x"][k], e["branch_y"][k]);
  }
  for (unsigned int k = 0; k < b["nx"].size(); ++k)
  {
    add(b["force_x"][k], b["force_y"][k], b["branch_x"][k], b["branch_y"][k]);
    add(b["moment_x"][k], b["moment_y"][k], -b["ny"][k], b["nx"][k]);
  }
  double area = 0.;
  for (const double of_cell : c["area"])
    area += of_cell;
  for (double &s : sum)
    s /= area;
  return sum;
}

/** The mean over the cells, by their areas. */
Stress mean_of_cells()
{
  Table c = read_table("output/cells.csv");
  Stress sum = {};
  double area = 0.;
  for (unsigned int k = 0; k < c["area"].size(); ++k)
  {
    area += c["area"][k];
    sum[0] += c["area"][k] * c["sxx"][k];
    sum[1] += c["area"][k] * c["sxy"][k];
    sum[2] += c["area"][k] * c["syx"][k];
    sum[3] += c["area"][k] * c["syy"][k];
  }
  for (double &s : sum)
    s /= area;
  return sum;
}

double difference(const Stress &a, const Stress &b)
{
  double largest = 0.;
  for (unsigned int k = 0; k < 4; ++k)
    largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

void run()
{
  work_in_own_directory();
  solve("subsection Loads\n set Boundary load = uniform stress\n"
        " set Stress = -1.5, 0.3; 0.3, -0.8\nend\n");
  check_error("the applied stress",
              difference(summed(), {{-1.5, 0.3, 0.3, -0.8}}), 1e-8);
  // A pressure that varies along the sides, in balance on the unit square.
  solve("subsection Loads\n set Traction = "
        "-nx * (1 + (y - 0.5)^2); -ny * (1 + (x - 0.5)^2)\nend\n");
  check_error("the mean over the cells", difference(summed(), mean_of_cells()),
              1e-9);
  // The mean of such a pressure over a side.
  check_error("the mean pressure", std::abs(summed()[0] + 1. + 1. / 12.), 1e-7);
}

const RoomTest test("mean_stress", run);
} // namespace test_mean_stress
