// SPDX-License-Identifier: LGPL-2.1-or-later

// Buildings of four walls: numbers of bricks, volumes and areas of joints in
// closed form, corners that interlock, openings and lintels; failures.

#include <voussoir/packing/polyhedra/generators/building.h>

#include "block_checks.h"

namespace test_space_building
{
using namespace Voussoir;

/** Bricks are 2 x 1 x 1; the plan is 12 x 8, the height 6. */
CellFaces generate(const std::string &settings)
{
  return generated<BuildingGenerator>(
      "set Length = 12\nset Width = 8\nset Height = 6\nset Thickness = 1\n"
      "set Brick length = 2\nset Brick height = 1\nset Lintel bearing = 0.5\n" +
      settings);
}

/** Joints in a course that are above one of the course below. */
unsigned int n_aligned(const CellFaces &cells, const unsigned int axis)
{
  const std::vector<Box3> boxes = boxes_of(cells);
  const Box3 all(cells.vertices);
  unsigned int n = 0;
  // A joint is where one box ends and another one begins.
  for (const Box3 &a : boxes)
    for (const Box3 &b : boxes)
      if (a.upper_bound(axis) == b.lower_bound(axis) &&
          common_extent(a, b, 1 - axis) > 0. && common_extent(a, b, 2) > 0.)
        for (const Box3 &c : boxes)
          n += c.lower_bound(2) == a.upper_bound(2) &&
               c.upper_bound(axis) == a.upper_bound(axis) &&
               c.upper_bound(axis) < all.upper_bound(axis) &&
               std::min({a.upper_bound(1 - axis), b.upper_bound(1 - axis),
                         c.upper_bound(1 - axis)}) >
                   std::max({a.lower_bound(1 - axis), b.lower_bound(1 - axis),
                             c.lower_bound(1 - axis)});
  return n;
}

/** Walls of whole bricks, where the thickness is half a brick. */
void check_whole_bricks(const unsigned int nx,
                        const unsigned int ny,
                        const unsigned int courses)
{
  std::cout << nx << " x " << ny << " bricks" << std::endl;
  const double length = 2. * nx, width = 2. * ny;
  const CellFaces cells =
      generate(text("set Length = ", length, "\nset Width = ", width,
                    "\nset Height = ", courses));
  // Of the walls that do not fill the corners each is one brick shorter.
  check("  cells", cells.n_cells() == courses * 2 * (nx + ny - 1));
  const double plan = length * width - (length - 2.) * (width - 2.);
  check_blocks(cells, plan * courses);
  const std::vector<Box3> boxes = boxes_of(cells);
  const auto areas = check_contacts(cells);
  bool whole = true;
  for (const Box3 &box : boxes)
    whole &= box.volume() == 2. && box.side_length(2) == 1.;
  check("  whole bricks", whole);
  check_error("  areas of beds", std::abs(areas[2] - plan * (courses - 1)),
              1e-12);
  // As many head joints as bricks in a ring.
  check_error("  areas of head joints",
              std::abs(areas[0] + areas[1] - courses * 2. * (nx + ny - 1)),
              1e-12);
  check("  no joints above each other",
        n_aligned(cells, 0) == 0 && n_aligned(cells, 1) == 0);
}

/** What is made if nothing is set: ten bricks by eight, in ten courses. */
void check_defaults()
{
  const CellFaces cells = generated<BuildingGenerator>("");
  check("Defaults: bricks", cells.n_cells() == 10 * 2 * (10 + 8 - 1));
  double volume = 0.;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    volume += moments_of(cells, c).volume;
  check_error("  their volume", std::abs(volume - 2. * (4. * 3.2 - 3.6 * 2.8)),
              1e-12);
}

void check_thickness(const double thickness)
{
  std::cout << "thickness " << thickness << std::endl;
  const CellFaces cells = generate(text("set Thickness = ", thickness));
  check_blocks(
      cells, 6. * (12. * 8. - (12. - 2. * thickness) * (8. - 2. * thickness)));
  const std::vector<Box3> boxes = boxes_of(cells);
  check_contacts(cells);
  check("  no joints above each other",
        n_aligned(cells, 0) == 0 && n_aligned(cells, 1) == 0);
  double shortest = 12.;
  for (const Box3 &box : boxes)
    shortest =
        std::min(shortest, std::max(box.side_length(0), box.side_length(1)));
  check("  no slivers", shortest >= 0.25);
}

void check_openings()
{
  std::cout << "openings" << std::endl;
  const CellFaces cells = generate(
      "set South openings = 5, 0, 7, 4; 1, 1, 3, 3\n"
      "set North openings = 3.3, 2, 8.7, 5\nset West openings = 3, 4, 5, 6\n"
      "set East openings = 1.3, 1, 6.7, 3");
  const double openings = 8. + 4. + 16.2 + 4. + 10.8;
  check_blocks(cells, 6. * (12. * 8. - 10. * 6.) - openings);
  const std::vector<Box3> boxes = boxes_of(cells);
  check_contacts(cells);
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    if (cells.group_names[cells.group[c]] == "lintel")
      std::cout << "  lintel from "
                << text_of_point<3>(boxes[c].get_boundary_points().first)
                << " to "
                << text_of_point<3>(boxes[c].get_boundary_points().second)
                << std::endl;
  // A block in the middle of an opening would be there.
  const auto is_filled = [&](const dealii::Point<3> &p) {
    return std::any_of(boxes.begin(), boxes.end(),
                       [&](const Box3 &box) { return box.point_inside(p); });
  };
  check("  in their walls",
        !is_filled({6., 0.5, 2.}) && !is_filled({2., 0.5, 2.}) &&
            !is_filled({6., 7.5, 3.}) && !is_filled({0.5, 4., 5.}) &&
            !is_filled({11.5, 4., 2.}) && is_filled({6., 7.5, 1.}) &&
            is_filled({11.5, 4., 5.}));
  check("  without lintels",
        group_sizes(generate("set South openings = 5, 0, 7, 4\n"
                             "set Lintels = false"))
                .count("lintel") == 0);
}

void refuse(const std::string &settings)
{
  show_refusal([&] { generate(settings); });
}

void run()
{
  check_defaults();
  check_whole_bricks(2, 2, 3);
  check_whole_bricks(6, 4, 6);
  check_whole_bricks(3, 7, 5);
  for (const double thickness : {0.3, 0.9, 1.3, 1.6, 2., 2.4, 3.})
    check_thickness(thickness);
  check_openings();

  refuse("set Thickness = 0");
  refuse("set Length = 11");
  refuse("set Width = 1.5");
  refuse("set Height = 5.5");
  refuse("set Thickness = 4");
  refuse("set Brick length = 1e-8");
  refuse("set South openings = 0.5, 0, 3, 2");
  refuse("set East openings = 2, 0, 7.5, 2");
  refuse("set West openings = 2, 0, 3, 7");
  refuse("set North openings = 4, 0, 6, 2; 5, 1, 7, 3");
  refuse("set North openings = 4, 0, 6, 2.2");
  refuse("set North openings = 4, 0, 6, 2; 6.1, 0, 8, 2");
  refuse("set East openings = 1.2, 1, 6, 3");
  refuse("set North openings = 4, 0, 6, 2; 6.1, 2, 8, 4");
}

const RoomTest test("space_building", run);
} // namespace test_space_building
