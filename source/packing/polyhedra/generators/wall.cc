// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/packing/generators/measures.h>
#include <voussoir/packing/polyhedra/generators/block_builder.h>
#include <voussoir/packing/polyhedra/generators/wall.h>
#include <voussoir/packing/polyhedra/generators/wall_courses.h>

#include <limits>

namespace Voussoir
{
namespace
{
/** The groups, in the order of their names. */
enum class WallGroup : unsigned int
{
  brick,
  lintel,
  through_stone
};

/** The number that a group of the wall has in a list of cells. */
constexpr unsigned int number_of(const WallGroup group)
{
  return static_cast<unsigned int>(group);
}

/** The thickness that a bond takes if it does not take @p n_widths. */
std::string demand_on_thickness(const WallBond bond,
                                const unsigned int n_widths)
{
  switch (bond)
  {
  case WallBond::running:
  case WallBond::stack: break;
  case WallBond::header:
    if (n_widths % 2 != 0)
      return "header bond takes an even number of them.";
    break;
  case WallBond::English:
    if (n_widths < 2)
      return "English bond takes 2 of them or more.";
    break;
  case WallBond::Flemish:
    if (n_widths != 2)
      return "Flemish bond takes 2 of them.";
    break;
  }
  return "";
}

/** Lay the bricks of a wall as one sees it from the front. */
class WallLayer
{
public:
  WallLayer(const WallElevation &elevation,
            const double thickness,
            const unsigned int n_widths)
      : elevation(elevation), thickness(thickness), n_widths(n_widths)
  {}

  /** @param spacing every some stone is a through stone; 0: none. */
  void lay(BlockBuilder &blocks,
           const unsigned int course,
           const BondRow &row,
           const WallInterval &gap,
           const unsigned int spacing)
  {
    for (const WallStone &stone : lay_row(elevation, row.pattern, gap))
    {
      ++n_stones;
      const bool is_through =
          spacing > 0 && stone.n_across > 1 && n_stones % spacing == 0;
      const unsigned int n = is_through ? 1 : stone.n_across;
      const unsigned int widths = (row.back - row.front) / n;
      for (unsigned int i = 0; i < n; ++i)
        add(blocks, course, {stone.left, stone.right},
            {{row.front + i * widths, row.front + (i + 1) * widths}},
            is_through ? WallGroup::through_stone : WallGroup::brick);
    }
  }

  /** Add a block, which is as high as its course. */
  void add(BlockBuilder &blocks,
           const unsigned int course,
           const WallInterval &place,
           const std::array<unsigned int, 2> &widths,
           const WallGroup group) const
  {
    blocks.add_box(
        {place.left, depth(widths[0]), elevation.bed_joint(course)},
        {place.right, depth(widths[1]), elevation.bed_joint(course + 1)},
        number_of(group));
  }

  /** The stones of the next row are counted from the first. */
  void begin_row() { n_stones = 0; }

private:
  /** A position in brick widths from the front; a length. */
  double depth(const unsigned int width) const
  {
    return thickness * width / n_widths;
  }

  const WallElevation &elevation;
  double thickness;
  unsigned int n_widths;
  unsigned int n_stones = 0;
};
} // namespace

void SpaceWallGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  const std::string uses = "Through stone spacing, Through stone courses";
  add_choice<WallBond>(
      prm, "Bond", bond,
      {{WallBond::running, "running",
        "leaves of bricks that lie along the wall; every second course is "
        "shifted by half a brick and has a half brick at either end.",
        uses},
       {WallBond::stack, "stack",
        "as running, but all head joints are above each other.", uses},
       {WallBond::header, "header",
        "all bricks lie across the wall; every second course is shifted by "
        "half a brick width. The thickness is an even number of brick widths.",
        uses},
       {WallBond::English, "English",
        "courses that show bricks along the wall and across it in turn; the "
        "thickness is two brick widths or more."},
       {WallBond::Flemish, "Flemish",
        "bricks along the wall, two side by side, and one across it in turn in "
        "every course; the thickness is two brick widths."}},
      "How the bricks overlap. Bricks that lie across the wall are twice as "
      "long as wide.");
  prm.add_parameter("Begin with second course", begins_with_second,
                    "Whether the lowest course is what is the second one "
                    "otherwise: in running bond that with half bricks.",
                    Bool());
  prm.add_parameter("Length", length,
                    "Length of the wall; a length, positive. Bricks are cut at "
                    "the right end if it is not a whole number of bricks.",
                    Double(0.));
  prm.add_parameter("Thickness", thickness,
                    "Thickness of the wall; a whole number of times 'Brick "
                    "width', which is the number of leaves.",
                    Double(0.));
  prm.add_parameter("Height", height,
                    "Height of the wall; a whole number of times 'Brick "
                    "height', which is the number of courses.",
                    Double(0.));
  prm.add_parameter("Brick length", brick_length,
                    "Length of a brick, a joint included; a length, positive.",
                    Double(0.));
  prm.add_parameter("Brick width", brick_width,
                    "Width of a brick, a joint included; a length, positive.",
                    Double(0.));
  prm.add_parameter("Brick height", brick_height,
                    "Height of a course; a length, positive.", Double(0.));
  prm.add_parameter("Through stone spacing", through_stone_spacing,
                    "Every how many bricks of a course that has through stones "
                    "one is of one block from the front to the back of a wall "
                    "of several leaves; 0 for none.",
                    Integer(0, 1000000));
  prm.add_parameter("Through stone courses", through_stone_courses,
                    "Every how many courses one has through stones, beginning "
                    "with the course of that number from the bottom.",
                    Integer(1, 1000000));
  add_parameters_of_openings(prm);
}

void SpaceWallGenerator::add_parameters_of_openings(
    dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter(
      "Openings", openings,
      "Openings \"x0, z0, x1, z1; x0, z0, x1, z1; ...\", each from its lower "
      "left corner x0, z0 to the upper right one x1, z1 and through the whole "
      "thickness; lengths from the lower left corner of the wall. They begin "
      "and end on bed joints; a door has z0 = 0. A brick cut to less than an "
      "eighth of one is joined to its neighbour in the row.",
      List(List(Double(), 4, 4, ","), 0, std::numeric_limits<int>::max(), ";"));
  prm.add_parameter("Lintels", has_lintels,
                    "Whether a lintel, one block one course high and as deep "
                    "as the wall, spans each opening that ends below the top "
                    "of the wall.",
                    *with_uses(Bool(), "true: Lintel bearing"));
  prm.add_parameter("Lintel bearing", lintel_bearing,
                    "How far a lintel rests on the wall on either side of the "
                    "opening; a length. It ends at the end of the wall; "
                    "lintels that would overlap are one.",
                    Double(0.));
}

SpaceWallGenerator::Numbers SpaceWallGenerator::check() const
{
  const std::string section = "Packing/wall";
  check_measures(section, {{"Length", length},
                           {"Thickness", thickness},
                           {"Height", height},
                           {"Brick length", brick_length},
                           {"Brick width", brick_width},
                           {"Brick height", brick_height}});
  const double courses = number_of_parts(section, {"Height", height},
                                         {"Brick height", brick_height});
  const double widths = number_of_parts(section, {"Thickness", thickness},
                                        {"Brick width", brick_width});
  check_number_of_cells(courses * widths * std::ceil(length / brick_length),
                        "'Packing/wall/Length', 'Thickness', 'Height' and the "
                        "measures of a brick");
  const Numbers numbers = {static_cast<unsigned int>(courses),
                           static_cast<unsigned int>(widths)};
  const std::string demand = demand_on_thickness(bond, numbers.n_widths);
  if (!demand.empty())
    throw InputError(text("'Packing/wall/Thickness' is ",
                          counted(numbers.n_widths, "brick width"), "; ",
                          demand));
  const bool has_headers = bond != WallBond::running && bond != WallBond::stack;
  if (has_headers && !is_same_length(brick_length, 2. * brick_width))
    throw InputError(
        text("'Packing/wall/Bond' takes bricks that are twice as long as wide, "
             "but 'Brick length' is ",
             text_to_copy(brick_length), " and 'Brick width' is ",
             text_to_copy(brick_width),
             "; change one of them, or set 'Bond' to running or stack."));
  return numbers;
}

bool SpaceWallGenerator::has_through_stones(const unsigned int course) const
{
  return through_stone_spacing > 0 && (course + 1) % through_stone_courses == 0;
}

CellFaces SpaceWallGenerator::generate(const std::filesystem::path &,
                                       Terminal &) const
{
  const Numbers numbers = check();
  WallElevation elevation(
      {length,
       height,
       numbers.n_courses,
       brick_length,
       {{{0., length}, {0., length}}}},
      "'Packing/wall/Openings'",
      "move an opening, or make it end where that piece does.");
  const std::vector<WallPart> holes = elevation.place_openings(openings);
  const std::vector<WallPart> lintels =
      has_lintels ? elevation.place_lintels(holes, lintel_bearing)
                  : std::vector<WallPart>();

  BlockBuilder blocks({"brick", "lintel", "through stone"});
  WallLayer layer(elevation, thickness, numbers.n_widths);
  for (unsigned int k = 0; k < numbers.n_courses; ++k)
  {
    const WallCourse course = divide_course(elevation, k, holes, lintels);
    const unsigned int spacing =
        has_through_stones(k) ? through_stone_spacing : 0;
    for (const BondRow &row : rows_of_course(
             bond, k + (begins_with_second ? 1 : 0), numbers.n_widths))
    {
      layer.begin_row();
      for (const WallInterval &gap : course.gaps)
        layer.lay(blocks, k, row, gap, spacing);
    }
    for (const WallInterval &lintel : course.lintels)
      layer.add(blocks, k, lintel, {{0, numbers.n_widths}}, WallGroup::lintel);
  }
  if (blocks.n_blocks() == 0)
    throw InputError("'Packing/wall/Openings' leave nothing of the wall; make "
                     "them smaller.");
  return blocks.take();
}
} // namespace Voussoir
