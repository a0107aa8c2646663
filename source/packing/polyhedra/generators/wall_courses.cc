// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polyhedra/generators/wall_courses.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** An opening or a lintel in a course. */
struct CoursePart
{
  WallInterval place;
  bool is_lintel;
};

/** From left to right. */
std::vector<CoursePart> parts_of_course(const unsigned int course,
                                        const std::vector<WallPart> &openings,
                                        const std::vector<WallPart> &lintels)
{
  std::vector<CoursePart> parts;
  for (const bool is_lintel : {false, true})
    for (const WallPart &part : is_lintel ? lintels : openings)
      if (part.first_course <= course && course < part.end_course)
        parts.push_back({{part.left, part.right}, is_lintel});
  std::sort(parts.begin(), parts.end(),
            [](const CoursePart &a, const CoursePart &b) {
              return a.place.left < b.place.left;
            });
  return parts;
}
} // namespace

WallCourse divide_course(const WallElevation &wall,
                         const unsigned int course,
                         const std::vector<WallPart> &openings,
                         const std::vector<WallPart> &lintels)
{
  std::vector<CoursePart> parts = parts_of_course(course, openings, lintels);
  WallCourse divided;
  if (parts.empty())
  {
    divided.gaps.push_back(wall.run(course));
    return divided;
  }
  for (std::size_t i = 0; i <= parts.size(); ++i)
  {
    CoursePart *const before = i > 0 ? &parts[i - 1] : nullptr;
    CoursePart *const behind = i < parts.size() ? &parts[i] : nullptr;
    const WallInterval gap = {
        before ? before->place.right : wall.run(course).left,
        behind ? behind->place.left : wall.run(course).right};
    if (!(gap.left < gap.right))
      continue;
    if (!wall.is_too_narrow(gap))
      divided.gaps.push_back(gap);
    else if (before && before->is_lintel)
      before->place.right = gap.right;
    else if (behind && behind->is_lintel)
      behind->place.left = gap.left;
    else
      wall.refuse_piece(course, gap);
  }
  for (const CoursePart &part : parts)
    if (part.is_lintel)
      divided.lintels.push_back(part.place);
  return divided;
}

std::vector<WallStone> lay_row(const WallElevation &wall,
                               const RowPattern &pattern,
                               const WallInterval &gap)
{
  const double quarter = wall.position(1);
  const auto length = wall.n_quarters();
  std::vector<WallStone> stones;
  double left = gap.left;
  const auto lay_until = [&](const double right) {
    const double middle = left + (right - left) / 2.;
    stones.push_back({left, right, pattern.n_across(middle / quarter, length)});
    left = right;
  };
  for (auto k = static_cast<unsigned int>(gap.left / quarter);
       wall.position(k) < gap.right; ++k)
    if (pattern.is_joint(k, length))
    {
      const double joint = wall.position(k);
      if (!wall.is_too_narrow({gap.left, joint}) &&
          !wall.is_too_narrow({joint, gap.right}))
        lay_until(joint);
    }
  lay_until(gap.right);
  return stones;
}
} // namespace Voussoir
