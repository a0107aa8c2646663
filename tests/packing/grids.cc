// SPDX-License-Identifier: LGPL-2.1-or-later

// Honeycombs and perturbed grids against counts in closed form: hexagons are
// regular and have six neighbours inside, quadrilaterals are convex at the
// largest perturbation; failures.

#include <voussoir/packing/generators/honeycomb.h>
#include <voussoir/packing/generators/perturbed_grid.h>

#include "tests.h"

namespace test_grids
{
using namespace Voussoir;

template <typename Generator>
Packing<2> generate(const std::string &settings)
{
  Generator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.parse_input_from_string(settings);
  return Packing<2>(generator.generate(".", Terminal::silent()));
}

/** How far lengths and angles are from those of a regular hexagon. */
double irregularity(const Packing<2> &packing, const double size)
{
  double largest = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < 6; ++i)
    {
      const auto a = packing.vertex(c, i + 1) - packing.vertex(c, i);
      const auto b = packing.vertex(c, i + 2) - packing.vertex(c, i + 1);
      largest =
          std::max({largest, std::abs(a.norm() * std::sqrt(3.) / size - 1),
                    std::abs(a * b / (a.norm() * b.norm()) - 0.5)});
    }
  return largest;
}

unsigned int n_neighbours(const Packing<2> &packing, const unsigned int cell)
{
  unsigned int n = 0;
  for (const auto &side : packing.sides(cell))
    n += !side.on_boundary;
  return n;
}

void check_honeycomb(const unsigned int columns,
                     const unsigned int rows,
                     const bool pointed)
{
  const double size = 0.3;
  const Packing<2> packing = generate<HoneycombGenerator>(
      "set Columns = " + std::to_string(columns) +
      "\nset Rows = " + std::to_string(rows) + "\nset Cell size = 0.3" +
      "\nset Orientation = " + (pointed ? "pointed top" : "flat top"));
  // Lines of hexagons side by side; one has n - 1 interfaces within, and two
  // have 2 n - 1 between them.
  const unsigned int lines = pointed ? rows : columns;
  const unsigned int n = pointed ? columns : rows;
  std::cout << columns << " x " << rows << (pointed ? " pointed" : " flat")
            << std::endl;
  check("  cells", packing.n_cells() == columns * rows);
  check("  interfaces", packing.interfaces().size() ==
                            lines * (n - 1) + (lines - 1) * (2 * n - 1));
  check("  boundary edges",
        packing.boundary_edges().size() ==
            6 * packing.n_cells() - 2 * packing.interfaces().size());
  check_error("  regular", irregularity(packing, size), 1e-13);
  bool six = true;
  for (unsigned int line = 1; line + 1 < lines; ++line)
    for (unsigned int k = 1; k + 1 < n; ++k)
      six &= n_neighbours(packing, line * n + k) == 6;
  check("  six neighbours inside", six);

  double left = 1e300, bottom = 1e300, upright = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < 6; ++i)
    {
      left = std::min(left, packing.vertex(c, i)[0]);
      bottom = std::min(bottom, packing.vertex(c, i)[1]);
    }
  for (const auto &side : packing.interfaces())
    upright = std::max(upright, std::abs(side.normal[pointed ? 0 : 1]));
  check_error("  begins at the origin", std::abs(left) + std::abs(bottom), 0.);
  if (n > 1)
    check_error("  stands as it should", std::abs(upright - 1.), 0.);
}

std::string grid(const unsigned int columns,
                 const unsigned int rows,
                 const std::string &perturbation,
                 const unsigned int seed)
{
  return "set Columns = " + std::to_string(columns) +
         "\nset Rows = " + std::to_string(rows) +
         "\nset Width = 3\nset Height = 0.5\nset Perturbation = " +
         perturbation + "\nset Seed = " + std::to_string(seed);
}

/** The smallest sine of an angle, in a grid of squares. */
double smallest_sine(const Packing<2> &packing)
{
  double smallest = 1.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < 4; ++i)
    {
      const auto a = packing.vertex(c, i + 1) - packing.vertex(c, i);
      const auto b = packing.vertex(c, i + 2) - packing.vertex(c, i + 1);
      smallest = std::min(smallest,
                          (a[0] * b[1] - a[1] * b[0]) / (a.norm() * b.norm()));
    }
  return smallest;
}

void check_grids()
{
  const unsigned int columns = 24, rows = 17;
  double area = 0., sides = 0., sine = 1.;
  bool counts = true;
  for (unsigned int seed = 0; seed < 50; ++seed)
  {
    const Packing<2> packing =
        generate<PerturbedGridGenerator>(grid(columns, rows, "0.35", seed));
    counts &= packing.n_cells() == columns * rows &&
              packing.interfaces().size() ==
                  columns * (rows - 1) + rows * (columns - 1) &&
              packing.boundary_edges().size() == 2 * (columns + rows);
    area = std::max(area, std::abs(packing.area() / 1.5 - 1.));
    for (const auto &edge : packing.boundary_edges())
      sides = std::max(sides, std::min({edge.start[0] + edge.end[0],
                                        edge.start[1] + edge.end[1],
                                        6. - edge.start[0] - edge.end[0],
                                        1. - edge.start[1] - edge.end[1]}));
    sine = std::min(sine, smallest_sine(packing));
  }
  std::cout << "50 grids with the largest perturbation" << std::endl;
  check("  cells, interfaces, boundary edges", counts);
  check_error("  area", area, 1e-13);
  check_error("  boundary edges on the sides", sides, 0.);
  check("  convex, some nearly not", sine > 0. && sine < 0.1);

  const auto vertices = [](const std::string &perturbation,
                           const unsigned int seed) {
    const Packing<2> packing =
        generate<PerturbedGridGenerator>(grid(9, 9, perturbation, seed));
    std::vector<dealii::Point<2>> all;
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      all.push_back(packing.vertex(c, 2)); // (i + 1, j + 1) of cell (i, j)
    return all;
  };
  const auto straight = vertices("0", 1), moved = vertices("0.2", 1);
  double unmoved = 0., largest = 0.;
  for (unsigned int c = 0; c < straight.size(); ++c)
  {
    unmoved = std::max(unmoved, straight[c].distance({3. * (c % 9 + 1) / 9,
                                                      0.5 * (c / 9 + 1) / 9}));
    const auto move = moved[c] - straight[c];
    largest = std::max(largest, std::hypot(move[0] * 9 / 3, move[1] * 9 / 0.5));
  }
  check_error("without perturbation a grid", unmoved, 1e-15);
  check("moved by up to a fifth of the spacing",
        largest <= 0.2 + 1e-14 && largest > 0.19);
  check("same seed, same grid", moved == vertices("0.2", 1));
  check("another seed, another grid", moved != vertices("0.2", 2));
}

void run()
{
  for (const bool pointed : {true, false})
  {
    check_honeycomb(1, 1, pointed);
    check_honeycomb(1, 5, pointed);
    check_honeycomb(4, 1, pointed);
    check_honeycomb(7, 12, pointed);
  }
  check_grids();

  show_refusal([] { generate<HoneycombGenerator>("set Cell size = 0"); });
  show_refusal([] { generate<PerturbedGridGenerator>("set Height = 0"); });
  try
  {
    generate<PerturbedGridGenerator>("set Perturbation = 0.36");
    std::cout << "FAILED: nothing was thrown" << std::endl;
  }
  catch (const dealii::ParameterHandler::ExcInvalidEntryForPattern &)
  {
    std::cout << "the perturbation is bounded: OK" << std::endl;
  }
}

const RoomTest test("grids", run);
} // namespace test_grids
