// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/packing/generators/measures.h>
#include <voussoir/packing/polyhedra/generators/block_builder.h>
#include <voussoir/packing/polyhedra/generators/building.h>
#include <voussoir/packing/polyhedra/generators/wall_courses.h>

#include <algorithm>
#include <limits>

namespace Voussoir
{
using dealii::Point;

namespace
{
constexpr unsigned int n_sides_of_building = 4;

/** The walls, as the entries on them begin. */
constexpr std::array<const char *, n_sides_of_building> names_of_sides = {
    {"South", "North", "West", "East"}};

/** The numbers of the groups of cells. */
constexpr unsigned int brick_of_building = 0;
constexpr unsigned int lintel_of_building = 1;

std::string entry_of_openings(const unsigned int side)
{
  return std::string(names_of_sides[side]) + " openings";
}

/**
 * True if the course of a wall that fills the corners begins with a half brick:
 * joints at whole bricks would be above the end of the wall in the next course.
 */
bool begins_with_half(const double thickness, const double brick_length)
{
  const double n_halves = std::round(2. * thickness / brick_length);
  return n_halves > 0. && std::fmod(n_halves, 2.) == 0.;
}

/** One wall of the building, with where it stands. */
class BuildingSide
{
public:
  /**
   * @param axis the direction along the wall: 0 for x, 1 for y.
   * @param across where it begins and ends in the other one; lengths.
   */
  BuildingSide(WallElevation wall,
               const unsigned int axis,
               const WallInterval &across)
      : elevation(std::move(wall)), axis(axis), across(across)
  {}

  /** Place the openings, and lintels if there is a @p bearing; lengths. */
  void open(const std::vector<std::array<double, 4>> &rectangles,
            const std::optional<double> &bearing)
  {
    holes = elevation.place_openings(rectangles);
    if (bearing)
      lintels = elevation.place_lintels(holes, *bearing);
  }

  /** Add the blocks of a course, with joints as in the course @p of_bond. */
  void lay(BlockBuilder &blocks,
           const unsigned int course,
           const unsigned int of_bond) const
  {
    const WallCourse parts = divide_course(elevation, course, holes, lintels);
    const std::vector<BondRow> rows =
        rows_of_course(WallBond::running, of_bond, 1);
    for (const WallInterval &gap : parts.gaps)
      for (const WallStone &stone :
           lay_row(elevation, rows.front().pattern, gap))
        add(blocks, course, {stone.left, stone.right}, brick_of_building);
    for (const WallInterval &lintel : parts.lintels)
      add(blocks, course, lintel, lintel_of_building);
  }

private:
  void add(BlockBuilder &blocks,
           const unsigned int course,
           const WallInterval &along,
           const unsigned int group) const
  {
    Point<3> low, high;
    low[axis] = along.left;
    high[axis] = along.right;
    low[1 - axis] = across.left;
    high[1 - axis] = across.right;
    low[2] = elevation.bed_joint(course);
    high[2] = elevation.bed_joint(course + 1);
    blocks.add_box(low, high, group);
  }

  WallElevation elevation;
  unsigned int axis;
  WallInterval across;
  std::vector<WallPart> holes, lintels;
};
} // namespace

void BuildingGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter("Length", length,
                    "Outer length of the south and the north wall, along x; a "
                    "whole number of times 'Brick length'.",
                    Double(0.));
  prm.add_parameter("Width", width,
                    "Outer length of the west and the east wall, along y; a "
                    "whole number of times 'Brick length'.",
                    Double(0.));
  prm.add_parameter("Height", height,
                    "Height of the walls; a whole number of times 'Brick "
                    "height', which is the number of courses.",
                    Double(0.));
  prm.add_parameter("Thickness", thickness,
                    "Thickness of the walls, which is the width of a brick; a "
                    "length, positive. Half of 'Brick length' makes corners of "
                    "whole bricks.",
                    Double(0.));
  prm.add_parameter("Brick length", brick_length,
                    "Length of a brick, a joint included; a length, positive.",
                    Double(0.));
  prm.add_parameter("Brick height", brick_height,
                    "Height of a course; a length, positive.", Double(0.));
  for (unsigned int side = 0; side < n_sides_of_building; ++side)
    prm.add_parameter(
        entry_of_openings(side), openings[side],
        text("Openings of that wall, \"",
             side < 2 ? "x0, z0, x1, z1" : "y0, z0, y1, z1",
             "; ...\", each from its lower left corner to the upper right one, "
             "seen such that ",
             side < 2 ? "x" : "y",
             " runs to the right; coordinates. They begin and end on bed "
             "joints and lie between the walls across; a door has z0 = 0."),
        List(List(Double(), 4, 4, ","), 0, std::numeric_limits<int>::max(),
             ";"));
  prm.add_parameter("Lintels", has_lintels,
                    "Whether a lintel, one block one course high and as deep "
                    "as the wall, spans each opening that ends below the top "
                    "of the wall.",
                    *with_uses(Bool(), "true: Lintel bearing"));
  prm.add_parameter("Lintel bearing", lintel_bearing,
                    "How far a lintel rests on the wall on either side of the "
                    "opening; a length. It ends where the course does; lintels "
                    "that would overlap are one.",
                    Double(0.));
}

unsigned int BuildingGenerator::check() const
{
  const std::string section = "Packing/building";
  const Measure brick = {"Brick length", brick_length};
  check_measures(section, {{"Length", length},
                           {"Width", width},
                           {"Height", height},
                           {"Thickness", thickness},
                           brick,
                           {"Brick height", brick_height}});
  const double courses = number_of_parts(section, {"Height", height},
                                         {"Brick height", brick_height});
  const double bricks = number_of_parts(section, {"Length", length}, brick) +
                        number_of_parts(section, {"Width", width}, brick);
  check_number_of_cells(2. * courses * bricks,
                        "'Packing/building/Length', 'Width', 'Height' and the "
                        "measures of a brick");
  for (const Measure &side :
       {Measure{"Length", length}, Measure{"Width", width}})
    if (side.value <= 2. * thickness)
      throw InputError(text("'Packing/building/Thickness' is ",
                            text_to_copy(thickness), ", and '", side.entry,
                            "' is ", text_to_copy(side.value),
                            "; that must be more than two thicknesses."));
  return static_cast<unsigned int>(courses);
}

CellFaces BuildingGenerator::generate(const std::filesystem::path &,
                                      Terminal &) const
{
  const unsigned int n_courses = check();
  // Where the walls across begin and end, along x and along y.
  const std::array<WallInterval, 2> inside = {
      {{thickness, length - thickness}, {thickness, width - thickness}}};
  std::vector<BuildingSide> sides;
  for (unsigned int side = 0; side < n_sides_of_building; ++side)
  {
    const unsigned int axis = side / 2;
    const double extent = axis == 0 ? length : width;
    const double across = axis == 0 ? width : length;
    std::array<WallInterval, 2> runs = {{{0., extent}, inside[axis]}};
    if (axis == 1)
      std::swap(runs[0], runs[1]);
    sides.emplace_back(
        WallElevation({extent, height, n_courses, brick_length, runs},
                      "'Packing/building/" + entry_of_openings(side) + "'",
                      "move an opening, or make it end where that piece does."),
        axis,
        side % 2 == 0 ? WallInterval{0., inside[1 - axis].left}
                      : WallInterval{inside[1 - axis].right, across});
    sides.back().open(openings[side], has_lintels
                                          ? std::optional(lintel_bearing)
                                          : std::nullopt);
  }

  const unsigned int shift = begins_with_half(thickness, brick_length) ? 1 : 0;
  BlockBuilder blocks({"brick", "lintel"});
  for (unsigned int k = 0; k < n_courses; ++k)
    for (unsigned int side = 0; side < n_sides_of_building; ++side)
      sides[side].lay(blocks, k, k + side / 2 + shift);
  return blocks.take();
}
} // namespace Voussoir
