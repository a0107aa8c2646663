// SPDX-License-Identifier: LGPL-2.1-or-later

// Walls with openings and lintels: areas and perimeters in closed form, jambs
// that are straight, lintels where they belong, no slivers; failures.

#include "tests.h"

namespace test_wall_openings
{
using namespace Voussoir;

/** A wall 20 long and 10 high; a stretcher is 4 long, a course 1 high. */
CellLoops generate(const std::string &settings)
{
  WallGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.parse_input_from_string(
      "set Width = 20\nset Height = 10\nset Courses = 10\n"
      "set Bricks per course = 5\nset Lintel bearing = 1\n" +
      settings);
  return generator.generate("", Terminal::silent());
}

std::string box(const dealii::Point<2> &low, const dealii::Point<2> &high)
{
  std::ostringstream out;
  out << '[' << low[0] << ", " << high[0] << "] x [" << low[1] << ", "
      << high[1] << ']';
  return out.str();
}

/** The rectangle that a cell fills. */
std::pair<dealii::Point<2>, dealii::Point<2>> corners(const Packing<2> &packing,
                                                      const unsigned int c)
{
  auto low = packing.vertex(c, 0), high = low;
  for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    for (unsigned int d = 0; d < 2; ++d)
    {
      low[d] = std::min(low[d], packing.vertex(c, i)[d]);
      high[d] = std::max(high[d], packing.vertex(c, i)[d]);
    }
  return {low, high};
}

/** Check a wall whose openings touch neither each other nor an end. */
void check_wall(const std::string &name,
                const std::string &settings,
                const double area,
                const double perimeter)
{
  const CellLoops cells = generate(settings);
  const Packing<2> packing(cells);
  std::cout << name << std::endl;
  double length = 0.;
  for (const auto &edge : packing.boundary_edges())
    length += edge.length;
  check_error("  area", std::abs(packing.area() - area), 1e-12);
  check_error("  perimeter", std::abs(length - perimeter), 1e-12);

  double narrowest = 20., fill = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    const auto [low, high] = corners(packing, c);
    if (cells.group_names[cells.group[c]] == "lintel")
      std::cout << "  lintel " << box(low, high) << std::endl;
    else
      narrowest = std::min(narrowest, high[0] - low[0]);
    fill = std::max(fill, std::abs(packing.area(c) -
                                   (high[0] - low[0]) * (high[1] - low[1])));
  }
  check("  no brick narrower than a quarter of a header",
        narrowest >= 0.5 - 1e-8);
  check_error("  cells are rectangles", fill, 1e-12);
}

void check_jambs()
{
  const Packing<2> packing(generate("set Openings = 7.3, 2, 12.9, 6"));
  double off_jamb = 0.;
  for (const auto &edge : packing.boundary_edges())
  {
    const auto middle = edge.midpoint();
    if (middle[0] > 0. && middle[0] < 20. && middle[1] > 0. && middle[1] < 10.)
      if (edge.normal[0] != 0.)
        off_jamb =
            std::max(off_jamb, std::abs(edge.start[0] -
                                        (edge.normal[0] > 0. ? 7.3 : 12.9)) +
                                   std::abs(edge.end[0] - edge.start[0]));
  }
  check_error("jambs straight and in place", off_jamb, 0.);
}

/** What is meant to be on a joint is on it, to the last bit. */
void check_snapping()
{
  const CellLoops exact = generate("set Openings = 8, 2, 12, 6");
  const CellLoops near =
      generate("set Openings = 8.00000001, 1.999999999, 12, 6.000000001");
  check("positions near a joint are on it",
        exact.vertices == near.vertices && exact.loops == near.loops);
}

void refuse(const std::string &settings)
{
  show_refusal([&] { generate(settings); });
}

void run()
{
  const double area = 200., perimeter = 60.;
  check_wall("a window", "set Openings = 8, 2, 12, 6", area - 16.,
             perimeter + 16.);
  check_wall("a door", "set Openings = 8, 0, 12, 6", area - 24.,
             perimeter + 12.);
  check_wall("a gap", "set Openings = 7.5, 5, 12.5, 10", area - 25.,
             perimeter + 10.);
  check_wall("no lintel", "set Openings = 8, 2, 12, 6\nset Lintels = false",
             area - 16., perimeter + 16.);
  check_wall("two windows, one lintel",
             "set Openings = 4, 2, 9, 6; 10.5, 3, 15, 6", area - 20. - 13.5,
             perimeter + 18. + 15.);
  check_wall("near an end, in Flemish bond",
             "set Bond = Flemish\nset Openings = 1.2, 1, 3.9, 4; "
             "9.87, 0, 13.03, 7",
             area - 8.1 - 3.16 * 7., perimeter + 11.4 + 14.);
  check_wall("slivers, in English bond",
             "set Bond = English\nset Openings = 4.1, 2, 7.6, 6", area - 14.,
             perimeter + 15.);
  check_jambs();
  check_snapping();

  refuse("set Openings = 8, 2, 8, 6");
  refuse("set Openings = 8, 6, 12, 2");
  refuse("set Openings = 8, 2, 12, 2.000000001");
  refuse("set Openings = 18, 2, 22, 6");
  refuse("set Openings = 8, -2, 12, 6");
  refuse("set Openings = 8, 2.5, 12, 6");
  refuse("set Openings = 8, 2, 12, 5.99");
  refuse("set Openings = 8, 2, 12, 6; 2, 2, 4, 4; 11, 5, 14, 8");
  refuse("set Openings = 8, 2, 12, 6; 11, 6, 14, 8");
  refuse("set Openings = 8, 2, 12, 6; 12.4, 2, 14, 6");
  refuse("set Openings = 0, 0, 20, 10");
}

const RoomTest test("wall_openings", run);
} // namespace test_wall_openings
