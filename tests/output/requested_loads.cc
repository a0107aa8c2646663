// SPDX-License-Identifier: LGPL-2.1-or-later

// Ten thousand random loads on packings of all generators: the forces and the
// moments in cells.csv and boundary.csv add up to those that were asked for.
// What was asked for is added up here from the numbers of the .prm file, with
// the vertices of packing.off: forces at their places or at centroids, and
// polynomials over edges and cells by Gauss's rules.

#include <voussoir/run/command_line/command_line.h>

#include "own_directory.h"
#include "random_loads.h"
#include "table.h"
#include "tests.h"
#include <array>
#include <fstream>
#include <random>

namespace test_requested_loads
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

constexpr unsigned int n_loads = 10000;

/** What every scene has: joints that carry all, and the packing in a file. */
const std::string common =
    "set Accuracy = draft\nset Formulation = least energy\n"
    "subsection Output\n set Files = csv\n set Report = false\n"
    " set Packing = OFF\nend\n"
    "subsection Friction\n set Strength = 100\nend\n"
    "subsection Contact\n set Tensile strength = 100\nend\n";

int run(const std::string &settings)
{
  std::ofstream("scene.prm") << common << settings;
  std::ostringstream out, error;
  const int status = run_command_line({"scene.prm"}, out, error);
  if (status != 0)
    std::cout << "FAILED: status " << status << ' ' << error.str() << settings;
  return status;
}

Geometry read_geometry()
{
  Geometry on;
  std::ifstream off("output/packing.off");
  std::string word;
  unsigned int n_vertices, n_cells, n_edges;
  off >> word >> n_vertices >> n_cells >> n_edges;
  Geometry::Ring vertices(n_vertices);
  double z;
  for (Point<2> &v : vertices)
    off >> v[0] >> v[1] >> z;
  on.cells.resize(n_cells);
  for (Geometry::Ring &ring : on.cells)
  {
    unsigned int n, k;
    off >> n;
    for (unsigned int i = 0; i < n; ++i)
    {
      off >> k;
      ring.push_back(vertices[k]);
    }
    for (unsigned int i = 0; i < n; ++i)
      on.concave += cross(ring[(i + 1) % n] - ring[i],
                          ring[(i + 2) % n] - ring[(i + 1) % n]) < -1e-9;
  }
  Table b = read_table("output/boundary.csv");
  for (unsigned int k = 0; k < b["nx"].size(); ++k)
    on.edges.push_back({{b["x0"][k], b["y0"][k]},
                        {b["x1"][k], b["y1"][k]},
                        Tensor<1, 2>({b["nx"][k], b["ny"][k]})});
  const dealii::BoundingBox<2> box(vertices);
  on.length = std::hypot(box.side_length(0), box.side_length(1));
  return on;
}

/** The sum of the tractions in boundary.csv. */
Sum sum_of_edges(const Point<2> &about)
{
  Sum sum;
  sum.about = about;
  Table b = read_table("output/boundary.csv");
  for (unsigned int k = 0; k < b["nx"].size(); ++k)
    sum.add(Point<2>(0.5 * (b["x0"][k] + b["x1"][k]),
                     0.5 * (b["y0"][k] + b["y1"][k])),
            Tensor<1, 2>({b["force_x"][k], b["force_y"][k]}),
            -b["ny"][k] * b["moment_y"][k] - b["nx"][k] * b["moment_x"][k]);
  return sum;
}

/**
 * The sum of the loads in cells.csv. Without rotations only the torque of all
 * forces is there, of which that of the interfaces is taken away.
 */
Sum sum_of_cells(const Point<2> &about)
{
  Sum sum;
  sum.about = about;
  Table c = read_table("output/cells.csv");
  std::vector<double> torque = c["load_torque"];
  if (torque.empty())
  {
    torque = c["torque"];
    Table e = read_table("output/interfaces.csv");
    for (unsigned int k = 0; k < e["nx"].size(); ++k)
    {
      const double n = e["normal_force"][k], t = e["tangential_force"][k];
      const Tensor<1, 2> f(
          {n * e["nx"][k] - t * e["ny"][k], n * e["ny"][k] + t * e["nx"][k]});
      const Point<2> x(0.5 * (e["x0"][k] + e["x1"][k]),
                       0.5 * (e["y0"][k] + e["y1"][k]));
      const unsigned int minus = e["cell_minus"][k];
      torque[minus] -= cross(x - Point<2>(c["x"][minus], c["y"][minus]), f);
      if (e["cell_plus"][k] < 0.)
        continue;
      const unsigned int plus = e["cell_plus"][k];
      torque[plus] += cross(x - Point<2>(c["x"][plus], c["y"][plus]), f);
    }
  }
  for (unsigned int k = 0; k < torque.size(); ++k)
    sum.add(Point<2>(c["x"][k], c["y"][k]),
            Tensor<1, 2>({c["load_x"][k], c["load_y"][k]}), torque[k]);
  return sum;
}

/** A random packing of a generator, with all or some of its boundary free. */
std::string random_packing_of(const std::string &generator)
{
  const auto number = [](const std::string &name, const double x) {
    return "set " + name + " = " + digits(x) + "\n";
  };
  const auto count = [](const std::string &name, const unsigned int n) {
    return "set " + name + " = " + std::to_string(n) + "\n";
  };
  std::string of, own = generator;
  if (generator == "Voronoi")
    of = count("Number of points", whole(3, 30)) + count("Seed", whole(1, 99));
  else if (generator == "wall")
    of = count("Courses", whole(2, 6)) +
         count("Bricks per course", whole(1, 5)) +
         number("Width", uniform(0.5, 2.)) +
         number("Height", uniform(0.5, 2.)) + "set Bond = " +
         std::array<std::string, 3>{
             {"running", "stack", "English"}}[whole(0, 2)] +
         "\n";
  else if (generator == "arch")
    of = number("Embrace", uniform(60., 180.)) +
         count("Voussoirs", whole(3, 15)) +
         number("Thickness", uniform(0.1, 0.5)) +
         count("Abutments", whole(0, 3));
  else if (generator == "honeycomb")
    of = count("Columns", whole(2, 5)) + count("Rows", whole(2, 5)) +
         number("Cell size", uniform(0.1, 1.));
  else if (generator == "perturbed grid")
    of = count("Columns", whole(2, 5)) + count("Rows", whole(2, 5)) +
         count("Seed", whole(1, 99));
  else
  {
    // An L and a Z that interlock, a gap beside them, and centres of their own.
    const double w = 0.01;
    const double x = uniform(0.3, 0.7), y = uniform(0.3, 0.7);
    std::ofstream wkt("blocks.wkt");
    wkt.precision(17);
    const auto block = [&](const std::vector<Point<2>> &ring) {
      wkt << "POLYGON ((";
      for (const Point<2> &v : ring)
        wkt << v[0] << ' ' << v[1] << ", ";
      wkt << ring[0][0] << ' ' << ring[0][1] << "))\n";
    };
    block({{0., 0.}, {1., 0.}, {1., y}, {x, y}, {x, 1.}, {0., 1.}});
    block({{x, y}, {1., y}, {1., 1.5}, {0., 1.5}, {0., 1.}, {x, 1.}});
    block({{1. + w, 0.}, {2., 0.}, {2., 1.5}, {1. + w, 1.5}});
    std::ofstream centres("centres.txt");
    centres << "0.1 0.1\n0.9 1.2\n" << uniform(1.2, 1.8) << " 0.7\n";
    of = "set File = blocks.wkt\nset Joint width = 0.02\n"
         "set Centres file = centres.txt\n";
    own = "polygons";
  }
  return std::string("set Rotations = ") + (whole(0, 1) ? "true" : "false") +
         "\nsubsection Packing\nset Generator = " + own + "\nsubsection " +
         own + '\n' + of + "end\nend\n" + "subsection Supports\nset Where = " +
         (whole(0, 9) == 0
              ? "1"
              : "nx < " + digits(uniform(-0.8, 0.)) + " || ny < -0.5") +
         "\nend\n";
}

std::string section(const std::string &name, const std::string &content)
{
  return "subsection " + name + '\n' + content + "end\n";
}

void run()
{
  work_in_own_directory();
  double worst_of_cells = 0., worst_of_edges = 0.;
  unsigned int n = 0, n_turning = 0, n_with_cases = 0;
  for (unsigned int k = 0; n < n_loads; ++k)
  {
    const std::string packing = random_packing_of(
        std::array<std::string, 6>{{"Voronoi", "wall", "arch", "honeycomb",
                                    "perturbed grid", "stones"}}[k % 6]);
    if (run(packing) != 0)
      return;
    const Geometry on = read_geometry();
    const Point<2> about = on.cells[0][0];
    for (unsigned int scene = 0; scene < 20; ++scene)
    {
      RandomLoads loads(on, about), of_case(on, about);
      const unsigned int n_here = whole(1, 12);
      for (unsigned int i = 0; i < n_here; ++i)
        loads.add_one();
      Sum edges = loads.on_edges, cells = loads.on_cells;
      std::string content = loads.settings(), cases;
      if (whole(0, 3) == 0)
      {
        ++n_with_cases;
        const double factor = uniform(0.1, 2.);
        const bool minus = whole(0, 1) == 0;
        for (unsigned int i = 0; i < 3; ++i)
          of_case.add_one();
        content += std::string("set Combination = ") + (minus ? "-" : "") +
                   digits(factor) + " other\n";
        cases = section("Load cases", section("other", of_case.settings()));
        edges.add(minus ? -factor : factor, of_case.on_edges);
        cells.add(minus ? -factor : factor, of_case.on_cells);
      }
      n += loads.n + of_case.n;
      if (run(packing + section("Loads", content) + cases) != 0)
        return;
      n_turning += read_table("output/cells.csv").count("load_torque");
      Sum all = edges;
      all.add(1., cells);
      if (edges.size > 0.)
        worst_of_edges = std::max(
            worst_of_edges, difference(sum_of_edges(about), edges, on.length));
      worst_of_cells = std::max(
          worst_of_cells, difference(sum_of_cells(about), all, on.length));
    }
  }
  check("ten thousand loads, with rotations and without, and load cases",
        n >= n_loads && n_turning > n / 30 && n_with_cases > n / 60);
  check_error("tractions in boundary.csv", worst_of_edges, 1e-12);
  check_error("loads in cells.csv", worst_of_cells, 1e-12);
}

const RoomTest test("requested_loads", run);
} // namespace test_requested_loads
