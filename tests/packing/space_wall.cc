// SPDX-License-Identifier: LGPL-2.1-or-later

// Walls of polyhedra: numbers of bricks and volumes in closed form, the front
// against walls of the plane, the bonds through the thickness, and through
// stones.

#include <voussoir/packing/polyhedra/generators/wall.h>

#include "block_checks.h"

namespace test_space_wall
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

std::string bond_of(const std::string &bond,
                    const unsigned int n_widths,
                    const double length)
{
  return text("set Bond = ", bond, "\nset Thickness = ", 2 * n_widths,
              "\nset Length = ", length, "\n");
}

/** x0, z0, x1, z1 of the cells at the front, sorted. */
std::vector<std::array<double, 4>> front_of(const CellFaces &cells)
{
  std::vector<std::array<double, 4>> front;
  for (const Box3 &box : boxes_of(cells))
    if (box.lower_bound(1) == 0.)
      front.push_back({{box.lower_bound(0), box.lower_bound(2),
                        box.upper_bound(0), box.upper_bound(2)}});
  std::sort(front.begin(), front.end());
  return front;
}

/** The same of a wall of the plane, whose stretchers are 4 x 1. */
std::vector<std::array<double, 4>> plane_wall(const std::string &settings)
{
  WallGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.parse_input_from_string(
      "set Width = 20\nset Height = 10\nset Courses = 10\n"
      "set Bricks per course = 5\nset Lintel bearing = 1\n" +
      settings);
  const CellLoops cells = generator.generate("", Terminal::silent());
  std::vector<std::array<double, 4>> rectangles;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    std::array<double, 4> box = {{1e9, 1e9, -1e9, -1e9}};
    for (unsigned int i = 0; i < cells.n_sides(c); ++i)
      for (unsigned int d = 0; d < 2; ++d)
      {
        const double x = cells.vertices[cells.corner(c, i)][d];
        box[d] = std::min(box[d], x);
        box[2 + d] = std::max(box[2 + d], x);
      }
    rectangles.push_back(box);
  }
  std::sort(rectangles.begin(), rectangles.end());
  return rectangles;
}

/** The front of a wall is that of the plane, with all bonds and openings. */
void check_front(const std::string &settings)
{
  for (const std::string bond : {"running", "stack", "English", "Flemish"})
    for (const std::string second : {"false", "true"})
    {
      const std::string all = "set Bond = " + bond +
                              "\nset Begin with second course = " + second +
                              "\n" + settings;
      check("  " + bond + ", second course " + second,
            front_of(generate("set Thickness = 4\n" + all)) == plane_wall(all));
    }
}

/** Joints across an axis of two courses that are above each other. */
struct Aligned
{
  unsigned int n = 0;   /**< their number */
  double from_end = 0.; /**< the largest distance from an end of the wall */
};

Aligned aligned_joints(const CellFaces &cells,
                       const unsigned int axis,
                       const double length)
{
  const std::vector<Box3> boxes = boxes_of(cells);
  const Box3 wall(cells.vertices);
  Aligned aligned;
  for (const Box3 &a : boxes)
    for (const Box3 &b : boxes)
      if (a.upper_bound(2) == b.lower_bound(2) &&
          a.upper_bound(axis) == b.upper_bound(axis) &&
          a.upper_bound(axis) < wall.upper_bound(axis) &&
          common_extent(a, b, 1 - axis) > 0.)
      {
        const double x = a.upper_bound(0);
        ++aligned.n;
        aligned.from_end = std::max(aligned.from_end, std::min(x, length - x));
      }
  return aligned;
}

void check_bond(const std::string &bond,
                const unsigned int n_widths,
                const double length)
{
  std::cout << bond << ", " << n_widths << " wide, " << length << " long"
            << std::endl;
  const CellFaces cells =
      generate(bond_of(bond, n_widths, length) + "set Height = 5");
  check_blocks(cells, length * 2 * n_widths * 5);
  const std::vector<Box3> boxes = boxes_of(cells);
  check_contacts(cells);
  double longest = 0., shortest = length, smallest = 1e9, largest = 0.;
  for (const Box3 &box : boxes)
  {
    longest = std::max(longest, box.side_length(0));
    shortest = std::min(shortest, box.side_length(0));
    smallest = std::min(smallest, box.volume());
    largest = std::max(largest, box.volume());
  }
  const bool whole = std::fmod(length, 1.) == 0.;
  check("  no brick larger than a whole one",
        longest <= (whole ? 4. : 4.5) && largest <= (whole ? 8. : 10.));
  check("  none shorter than a closer, or than a cut one",
        shortest >= (whole ? 1. : 0.5));
  check("  none smaller than half a stretcher or a closer",
        smallest >= (whole ? 2. : 1.));
  const Aligned heads = aligned_joints(cells, 0, length);
  const bool at_ends = bond == "English" && n_widths > 2;
  check("  head joints above each other",
        bond == "stack" ? heads.n > 0
                        : (heads.n > 0) == at_ends && heads.from_end <= 2.);
  const bool is_bonded =
      bond == "English" || n_widths == 1 || (bond == "header" && n_widths == 2);
  check("  joints between rows above each other",
        (aligned_joints(cells, 1, length).n == 0) == is_bonded);
}

/** Numbers of bricks in walls n stretchers long, of two courses. */
void check_numbers(const unsigned int n)
{
  const auto count = [&](const std::string &bond, const unsigned int n_widths) {
    return generate(bond_of(bond, n_widths, 4 * n) + "set Height = 2")
        .n_cells();
  };
  check(text("numbers of bricks, ", n, " stretchers long"),
        count("running", 1) == n + (n + 1) &&
            count("running", 3) == 3 * (n + n + 1) &&
            count("stack", 2) == 4 * n &&
            count("header", 2) == 2 * n + (2 * n + 1) &&
            count("header", 4) == 2 * (2 * n + (2 * n + 1)) &&
            count("English", 2) == 2 * n + (2 * n + 1) &&
            count("English", 3) == (n + 2 * n) + (2 * n + 1 + n + 1) &&
            count("English", 4) == (n + 2 * n + n) + 2 * (2 * n + 1));
  if (n % 3 == 1)
  {
    const unsigned int p = 2 * (n - 1) / 3;
    check("  in Flemish bond",
          count("Flemish", 2) == (3 * p + 2) + (n == 1 ? 2 : 3 * p + 3));
  }
}

/** The areas of beds and joints in closed form. */
void check_areas()
{
  // 5 courses of 5 bricks, with halves at the ends of the second and fourth.
  std::cout << "three leaves" << std::endl;
  const auto areas =
      areas_of_contacts(generate("set Thickness = 6\nset Height = 5"));
  check_error("  beds", std::abs(areas[2] - 4 * 20. * 6.), 1e-10);
  check_error("  head joints", std::abs(areas[0] - (3 * 4 + 2 * 5) * 6.),
              1e-10);
  check_error("  between leaves", std::abs(areas[1] - 2 * 20. * 5.), 1e-10);
}

void check_through_stones()
{
  // Every second brick of the third and sixth course, of 5 bricks and of 6.
  const CellFaces cells = generate("set Thickness = 6\nset Through stone "
                                   "spacing = 2\nset Through stone courses = "
                                   "3\nset Begin with second course = false");
  check_blocks(cells, 20. * 6. * 10.);
  auto sizes = group_sizes(cells);
  const unsigned int n_through = 2 + 3 + 2; // third, sixth, ninth course
  check("  number", sizes["through stone"] == n_through);
  check("  bricks", sizes["brick"] == 3 * (5 * 5 + 5 * 6 - n_through));
  const std::vector<Box3> boxes = boxes_of(cells);
  check_contacts(cells);
  bool in_place = true;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    if (cells.group_names[cells.group[c]] == "through stone")
      in_place &= boxes[c].side_length(1) == 6. &&
                  std::fmod(boxes[c].upper_bound(2), 3.) == 0. &&
                  std::fmod(boxes[c].lower_bound(0), 8.) ==
                      (boxes[c].upper_bound(2) == 6. ? 2. : 4.);
  check("  in place", in_place);
  check("  none in a wall of one leaf",
        group_sizes(generate("set Through stone spacing = 1"))
                .count("through stone") == 0);
}

void run()
{
  std::cout << "front as in the plane" << std::endl;
  check_front("");
  check_front("set Openings = 7.3, 2, 12.9, 6");
  check_front("set Openings = 4, 2, 9, 6; 10.5, 3, 15, 6");
  check_front("set Lintels = false\nset Openings = 1.2, 1, 3.9, 4; 9.87, 0, "
              "13.03, 7");
  for (const unsigned int n : {2, 3, 4, 5, 7, 10})
    check_numbers(n);
  for (const double length : {12., 14., 20., 17.3})
    for (const auto &[bond, n_widths] :
         std::vector<std::pair<std::string, unsigned int>>{{"running", 1},
                                                           {"running", 3},
                                                           {"stack", 2},
                                                           {"header", 2},
                                                           {"header", 4},
                                                           {"English", 2},
                                                           {"English", 3},
                                                           {"English", 4},
                                                           {"English", 5},
                                                           {"Flemish", 2}})
      check_bond(bond, n_widths, length);
  check_areas();
  std::cout << "through stones" << std::endl;
  check_through_stones();
}

const RoomTest test("space_wall", run);
} // namespace test_space_wall
