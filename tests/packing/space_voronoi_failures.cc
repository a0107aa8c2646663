// SPDX-License-Identifier: LGPL-2.1-or-later

// What the Voronoi cells of space refuse: points files, points, domains and
// parameters, with the messages.

#include <voussoir/packing/polyhedra/voronoi/voronoi.h>

#include "tests.h"
#include <fstream>
#include <limits>

namespace test_space_voronoi_failures
{
using namespace Voussoir;
using dealii::Point;

const double infinity = std::numeric_limits<double>::infinity();

void generate(const std::string &settings)
{
  SpaceVoronoiGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.parse_input_from_string(settings);
  generator.generate(".", Terminal::silent());
}

void generate_from(const std::string &points, const std::string &settings = "")
{
  std::ofstream("points_in_space.txt") << points;
  generate(settings +
           "set Points = file\nset Points file = points_in_space.txt");
}

void refuse_points(const std::vector<Point<3>> &points,
                   const Box &box = {{0., 0., 0.}, {1., 1., 1.}})
{
  PointList<3> list;
  list.points = points;
  show_refusal([&] { voronoi_cells(list, ConvexPolyhedron(box)); });
}

void refuse_hull(const std::vector<Point<3>> &points)
{
  show_refusal([&] { ConvexPolyhedron polyhedron(points); });
}

void run()
{
  for (const char *content : {"", "1 2 3\n1 2\n", "1 2 3 4\n", "1 2 z\n",
                              "1 2 nan\n", "0,5 0,5 0,5\n"})
    show_refusal([&] { generate_from(content); });
  show_refusal([] { generate("set Points = file"); });
  show_refusal([] {
    generate("set Points = file\nset Points file = no_such_file.txt");
  });

  show_refusal([] { generate_from("0.5 0.5 0.5\n\n0.5 1.5 0.5\n"); });
  show_refusal([] { generate_from("0.5 0.5 1\n"); });
  show_refusal([] { generate_from("0.5 0.5 0.5\n.1 .2 .3\n0.5 0.5 0.5\n"); });
  show_refusal([] { generate_from("0.5 0.5 0.5\n.1 .2 .3\n.1 .2 .3\n"); });
  show_refusal([] { generate_from("0.5 0.5 0.5\n0.5 0.5 0.50000000001\n"); });
  refuse_points({});
  refuse_points({{0.5, 0.5, std::nan("")}});
  refuse_points({{0.5, 0.5, 0.5}, {0.5, infinity, 0.5}});
  refuse_points({{5e5, 5e5, 5e5}, {5e5, 5e5, 5e5 + 1e-8}},
                {{4e5, 4e5, 4e5}, {6e5, 6e5, 6e5}});

  show_refusal([] { generate("set Upper corner = 1, 1, 0"); });
  show_refusal([] { generate("set Upper corner = 1e-60, 1e-60, 1e-60"); });
  show_refusal([] { generate("set Upper corner = 1, 1e60, 1"); });
  show_refusal([] { generate("set Domain = polyhedron"); });
  show_refusal([] {
    generate("set Domain = polyhedron\n"
             "set Polyhedron = 0, 0, 0; 1, 0, 0; 1, 1, 0; 0, 1, 0");
  });
  show_refusal([] {
    generate_from("0.9 0.9 0.9\n",
                  "set Domain = polyhedron\n"
                  "set Polyhedron = 0, 0, 0; 1, 0, 0; 0, 1, 0; 0, 0, 1\n");
  });
  refuse_hull({});
  refuse_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  refuse_hull({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
  refuse_hull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}});
  refuse_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 1e-12}, {1, 1, 0}});
  refuse_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, infinity}});
  refuse_hull({{0, 0, 0}, {1e-60, 0, 0}, {0, 1e-60, 0}, {0, 0, 1e-60}});
  refuse_hull({{1e60, 0, 0}, {2e60, 0, 0}, {0, 1e60, 0}, {0, 0, 1e60}});

  show_refusal([] { generate("set Cell size = x +"); });
  show_refusal([] { generate("set Cell size = z - 0.3"); });
  show_refusal([] { generate("set Cell size = 0"); });
  show_refusal(
      [] { generate("set Cell size = abs(z - 0.123456789) + 1e-150"); });
}

const RoomTest test("space_voronoi_failures", run);
} // namespace test_space_voronoi_failures
