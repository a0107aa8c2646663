// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/generators/wall.h>
#include <voussoir/packing/generators/wall_grid.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace Voussoir
{
namespace
{
/** One cell of a course, from left to right: a brick or a lintel; lengths. */
struct Stone
{
  double left, right;
  bool is_lintel;
};

/** The stones of a course from left to right, with gaps at openings. */
using Course = std::vector<Stone>;

/** The parts of a course that are not for bricks: lintels and openings. */
Course reserved_parts(const unsigned int course,
                      const std::vector<WallPart> &openings,
                      const std::vector<WallPart> &lintels)
{
  Course reserved;
  for (const bool is_lintel : {false, true})
    for (const WallPart &part : is_lintel ? lintels : openings)
      if (part.first_course <= course && course < part.end_course)
        reserved.push_back({part.left, part.right, is_lintel});
  std::sort(reserved.begin(), reserved.end(),
            [](const Stone &a, const Stone &b) { return a.left < b.left; });
  return reserved;
}

Course cut_bricks(const WallGrid &grid,
                  const std::vector<unsigned int> &joints,
                  const Course &reserved)
{
  Course stones;
  double left = 0.;
  auto joint = joints.begin();
  const auto lay_bricks_until = [&](const double end) {
    for (; joint != joints.end() && grid.head_joint(*joint) < end; ++joint)
      if (const double right = grid.head_joint(*joint); right > left)
      {
        stones.push_back({left, right, false});
        left = right;
      }
    if (left < end)
      stones.push_back({left, end, false});
  };
  for (const Stone &part : reserved)
  {
    lay_bricks_until(part.left);
    if (part.is_lintel)
      stones.push_back({part.left, part.right, true});
    left = part.right;
  }
  lay_bricks_until(grid.width());
  return stones;
}

Course
without_slivers(const WallGrid &grid, const unsigned int course, Course stones)
{
  const double header = grid.head_joint(quarters_in_stretcher) / 2.;
  const double narrowest = header / 4.;
  Course joined;
  for (unsigned int i = 0; i < stones.size(); ++i)
  {
    const Stone stone = stones[i];
    if (stone.is_lintel ||
        stone.right - stone.left >= narrowest - grid.resolution())
    {
      joined.push_back(stone);
      continue;
    }
    const bool has_left = !joined.empty() && joined.back().right == stone.left;
    const bool has_right =
        i + 1 < stones.size() && stones[i + 1].left == stone.right;
    const bool right_is_brick = has_right && !stones[i + 1].is_lintel;
    if (has_left && !(joined.back().is_lintel && right_is_brick))
      joined.back().right = stone.right;
    else if (has_right)
      stones[i + 1].left = stone.left;
    else
      throw InputError(text(
          "'Packing/wall/Openings' leave a piece of wall from ",
          text_of_point({stone.left, grid.bed_joint(course)}), " to ",
          text_of_point({stone.right, grid.bed_joint(course + 1)}),
          " that is narrower than a quarter of a header, which is ", narrowest,
          "; move an opening, or make it end where that piece does."));
  }
  return joined;
}

/**
 * Lay a course: the lintels in it, and between them and the openings bricks
 * with head joints where the bond has them. A brick that is cut to less than a
 * quarter of a header is joined to its neighbour, to a brick if there is one;
 * without a neighbour it is refused.
 *
 * @param first the course of the bond that is the lowest one.
 */
Course lay_course(const WallGrid &grid,
                  const Bond bond,
                  const unsigned int course,
                  const unsigned int first,
                  const std::vector<WallPart> &openings,
                  const std::vector<WallPart> &lintels)
{
  return without_slivers(
      grid, course,
      cut_bricks(grid, head_joints(bond, first + course, grid.n_stretchers()),
                 reserved_parts(course, openings, lintels)));
}

/** The vertices on one bed joint: where stones end below or above it. */
class BedJoint
{
public:
  /** Add the vertices, at the height @p y. */
  BedJoint(CellLoops &cells,
           const double y,
           const Course &below,
           const Course &above)
      : first_vertex(cells.vertices.size())
  {
    for (const Course *course : {&below, &above})
      for (const Stone &stone : *course)
        positions.insert(positions.end(), {stone.left, stone.right});
    std::sort(positions.begin(), positions.end());
    positions.erase(std::unique(positions.begin(), positions.end()),
                    positions.end());
    for (const double x : positions)
      cells.vertices.emplace_back(x, y);
  }

  /** The vertices along a stone, from left to right. */
  std::vector<unsigned int> along(const Stone &stone) const
  {
    const auto left =
        std::lower_bound(positions.begin(), positions.end(), stone.left);
    const auto end = std::upper_bound(left, positions.end(), stone.right);
    std::vector<unsigned int> vertices(end - left);
    std::iota(vertices.begin(), vertices.end(),
              first_vertex + (left - positions.begin()));
    return vertices;
  }

private:
  unsigned int first_vertex;
  std::vector<double> positions;
};

void add_cells(CellLoops &cells,
               const Course &course,
               const BedJoint &below,
               const BedJoint &above)
{
  for (const Stone &stone : course)
  {
    std::vector<unsigned int> loop = below.along(stone);
    const std::vector<unsigned int> upper = above.along(stone);
    loop.insert(loop.end(), upper.rbegin(), upper.rend());
    cells.add(loop);
    cells.group.push_back(stone.is_lintel ? 1 : 0);
  }
}
} // namespace

void WallGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  add_choice<Bond>(
      prm, "Bond", bond,
      {{Bond::running, "running",
        "every second course is shifted by half a brick and has a half brick "
        "at either end."},
       {Bond::stack, "stack", "all head joints are above each other."},
       {Bond::English, "English",
        "courses of stretchers, which show their length, and of headers, which "
        "show half of it, in turn."},
       {Bond::Flemish, "Flemish",
        "stretcher and header in turn in every course; symmetric if 'Bricks "
        "per course' is 1, 4, 7, ..."}},
      "How the bricks overlap.");
  prm.add_parameter("Begin with second course", begins_with_second,
                    "Whether the lowest course is what is the second one "
                    "otherwise: in running bond that with half bricks.",
                    Bool());
  prm.add_parameter("Courses", n_courses, "Number of courses, bottom to top.",
                    Integer(1, 1000000));
  prm.add_parameter("Bricks per course", n_bricks,
                    "The width of the wall in stretchers, which is the number "
                    "of bricks in the bottom course unless the bond is "
                    "Flemish.",
                    Integer(1, 1000000));
  prm.add_parameter("Width", width, "Width of the wall; a length, positive.",
                    Double(0.));
  prm.add_parameter("Height", height, "Height of the wall; a length, positive.",
                    Double(0.));
  prm.add_parameter(
      "Openings", openings,
      "Openings \"x0, y0, x1, y1; x0, y0, x1, y1; ...\", each from its lower "
      "left corner x0, y0 to the upper right one x1, y1; lengths from the "
      "lower left corner of the wall. They begin and end on bed joints; a door "
      "has y0 = 0. A brick cut to less than a quarter of a header is joined to "
      "its neighbour in the course.",
      List(List(Double(), 4, 4, ","), 0, std::numeric_limits<int>::max(), ";"));
  prm.add_parameter("Lintels", has_lintels,
                    "Whether a lintel, one course high, spans each opening "
                    "that ends below the top of the wall.",
                    *with_uses(Bool(), "true: Lintel bearing"));
  prm.add_parameter("Lintel bearing", lintel_bearing,
                    "How far a lintel rests on the wall on either side of the "
                    "opening; a length. It ends at the end of the wall; "
                    "lintels that would overlap are one.",
                    Double(0.));
}

CellLoops WallGenerator::generate(const std::filesystem::path &,
                                  Terminal &) const
{
  check_size("wall 'Packing/wall'", width, height);
  check_number_of_cells(double(n_courses) * n_bricks,
                        "'Packing/wall/Courses' and 'Bricks per course'");

  WallGrid grid(width, height, n_courses, n_bricks);
  const std::vector<WallPart> gaps = grid.place_openings(openings);
  const std::vector<WallPart> lintels =
      has_lintels ? grid.place_lintels(gaps, lintel_bearing)
                  : std::vector<WallPart>();

  const unsigned int first = begins_with_second ? 1 : 0;
  CellLoops cells;
  cells.group_names = {"brick", "lintel"};
  Course course = lay_course(grid, bond, 0, first, gaps, lintels);
  BedJoint below(cells, grid.bed_joint(0), {}, course);
  for (unsigned int k = 0; k < n_courses; ++k)
  {
    Course next = k + 1 < n_courses
                      ? lay_course(grid, bond, k + 1, first, gaps, lintels)
                      : Course();
    BedJoint above(cells, grid.bed_joint(k + 1), course, next);
    add_cells(cells, course, below, above);
    course = std::move(next);
    below = std::move(above);
  }
  if (cells.group.empty())
    throw InputError("'Packing/wall/Openings' leave nothing of the wall; make "
                     "them smaller.");
  return cells;
}
} // namespace Voussoir
