// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/generators/wall_courses.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
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
} // namespace

Course lay_course(const WallGrid &grid,
                  const Bond bond,
                  const unsigned int course,
                  const std::vector<WallPart> &openings,
                  const std::vector<WallPart> &lintels)
{
  return without_slivers(
      grid, course,
      cut_bricks(grid, head_joints(bond, course, grid.n_stretchers()),
                 reserved_parts(course, openings, lintels)));
}
} // namespace Voussoir
