// SPDX-License-Identifier: LGPL-2.1-or-later

// Walls of polyhedra with openings and lintels: volumes in closed form, no
// slivers, places that are the same to the last bit; failures.

#include <voussoir/packing/polyhedra/generators/wall.h>

#include "block_checks.h"

namespace test_space_wall_openings
{
using namespace Voussoir;

/** Bricks are 4 x 2 x 1; the wall is 20 long and 10 high. */
CellFaces generate(const std::string &settings)
{
  return generated<SpaceWallGenerator>(
      "set Length = 20\nset Thickness = 2\nset Height = 10\n"
      "set Brick length = 4\nset Brick width = 2\nset Brick height = 1\n"
      "set Lintel bearing = 1\n" +
      settings);
}

std::string text_of_box(const Box3 &box)
{
  return "from " + text_of_point<3>(box.get_boundary_points().first) + " to " +
         text_of_point<3>(box.get_boundary_points().second);
}

void check_openings(const std::string &name,
                    const std::string &settings,
                    const double area)
{
  std::cout << name << std::endl;
  for (const std::string bond : {"running", "English"})
  {
    const CellFaces cells =
        generate("set Thickness = 6\nset Bond = " + bond + "\n" + settings);
    check_blocks(cells, 6. * area);
    const std::vector<Box3> boxes = boxes_of(cells);
    check_contacts(cells);
    double narrowest = 20.;
    for (unsigned int c = 0; c < cells.n_cells(); ++c)
      if (cells.group_names[cells.group[c]] != "lintel")
        narrowest = std::min(narrowest, boxes[c].side_length(0));
      else if (bond == "running")
        std::cout << "  lintel " << text_of_box(boxes[c]) << std::endl;
    check("  no brick narrower than an eighth", narrowest >= 0.5 - 1e-8);
  }
}

/** Vertices of blocks that meet are the same to the last bit. */
void check_common_places()
{
  const CellFaces cells = generate(
      "set Thickness = 0.7\nset Brick width = 0.1\nset Height = 0.7\n"
      "set Brick height = 0.1\nset Length = 1.3\nset Brick length = 0.3\n"
      "set Lintel bearing = 0.07\nset Openings = 0.31, 0.1, 0.77, 0.3");
  double closest = 1.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    std::vector<double> places;
    for (const auto &vertex : cells.vertices)
      places.push_back(vertex[d]);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (unsigned int i = 1; i < places.size(); ++i)
      closest = std::min(closest, places[i] - places[i - 1]);
  }
  check("places are the same or differ", closest > 1e-3);
  check("positions near a joint are on it",
        generate("set Openings = 8, 2, 12, 6").vertices ==
            generate("set Openings = 8.00000001, 1.999999999, 12, "
                     "6.000000001")
                .vertices);
}

/** Walls of another unit of length have the same bricks. */
void check_scales()
{
  const auto scaled = [](const double unit) {
    return generate(
        text("set Bond = English\nset Thickness = ", 6 * unit,
             "\nset Length = ", 20 * unit, "\nset Height = ", 10 * unit,
             "\nset Brick length = ", 4 * unit,
             "\nset Brick width = ", 2 * unit, "\nset Brick height = ", unit,
             "\nset Lintel bearing = ", unit, "\nset Openings = ", 7.3 * unit,
             ", ", 2 * unit, ", ", 12.9 * unit, ", ", 6 * unit));
  };
  const CellFaces wall = scaled(1.);
  const ContactCount contacts = count_contacts(wall, {wall.tolerance});
  for (const double unit : {1e-6, 1e-3, 1e3, 1e6})
  {
    const CellFaces other = scaled(unit);
    const ContactCount same = count_contacts(other, {other.tolerance});
    check(text("a wall ", unit, " times as large"),
          other.n_cells() == wall.n_cells() && other.group == wall.group &&
              same.patches == contacts.patches &&
              same.pairs_of_cells == contacts.pairs_of_cells);
    check_error(
        "  volume",
        std::abs(volume_of(other) / std::pow(unit, 3) / (6. * (200. - 22.4)) -
                 1.),
        1e-12);
  }
}

void refuse(const std::string &settings)
{
  show_refusal([&] { generate(settings); });
}

void check_failures()
{
  refuse("set Length = 0");
  refuse("set Brick height = 0");
  refuse("set Height = 9.5");
  refuse("set Height = 0.4");
  refuse("set Thickness = 5");
  refuse("set Brick height = 1e-9\nset Height = 1");
  refuse("set Bond = Flemish");
  refuse("set Bond = English");
  refuse("set Bond = header\nset Thickness = 6");
  refuse("set Bond = English\nset Thickness = 4\nset Brick length = 5");
  refuse("set Openings = 8, 2, 8, 6");
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

void run()
{
  check_openings("a window", "set Openings = 8, 2, 12, 6", 200. - 16.);
  check_openings("a door", "set Openings = 8, 0, 12, 6", 200. - 24.);
  check_openings("a gap", "set Openings = 7.5, 5, 12.5, 10", 200. - 25.);
  check_openings("two windows, one lintel",
                 "set Openings = 4, 2, 9, 6; 10.5, 3, 15, 6",
                 200. - 20. - 13.5);
  check_openings("a lintel to the end", "set Openings = 1.3, 2, 7.6, 6",
                 200. - 25.2);
  check_common_places();
  check_scales();
  check("a wall narrower than a piece of a brick",
        generate("set Length = 0.3").n_cells() == 10);
  check_failures();
}

const RoomTest test("space_wall_openings", run);
} // namespace test_space_wall_openings
