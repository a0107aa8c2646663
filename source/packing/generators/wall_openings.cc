// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/generators/wall_openings.h>

#include <algorithm>
#include <tuple>

namespace Voussoir
{
namespace
{
std::string describe(const std::array<double, 4> &rectangle)
{
  return text("opening from ", text_of_point({rectangle[0], rectangle[1]}),
              " to ", text_of_point({rectangle[2], rectangle[3]}));
}

std::string describe(const WallGrid &grid, const WallPart &opening)
{
  return describe({{opening.left, grid.bed_joint(opening.first_course),
                    opening.right, grid.bed_joint(opening.end_course)}});
}

[[noreturn]] void refuse(const std::array<double, 4> &rectangle,
                         const std::string &fault)
{
  throw InputError("The " + describe(rectangle) +
                   " in 'Packing/wall/Openings' " + fault);
}

/** The bed joint at the bottom or the top of an opening. */
unsigned int find_level(const WallGrid &grid,
                        const std::array<double, 4> &rectangle,
                        const bool top)
{
  const double y = rectangle[top ? 3 : 1];
  if (const auto level = grid.level_at(y))
    return *level;
  const double height = grid.bed_joint(grid.n_courses());
  const auto above =
      static_cast<unsigned int>(y / height * grid.n_courses()) + 1;
  refuse(rectangle, text("has its ", top ? "top" : "bottom", " at the height ",
                         text_to_copy(y),
                         ", which is not on a bed joint; the nearest are "
                         "at ",
                         text_to_copy(grid.bed_joint(above - 1)), " and ",
                         text_to_copy(grid.bed_joint(above)), "."));
}

WallPart place_opening(WallGrid &grid, const std::array<double, 4> &rectangle)
{
  const std::string no_area = "has no area; give \"x0, y0, x1, y1\" with "
                              "x0 < x1 and y0 < y1.";
  const double bottom = rectangle[1], top = rectangle[3];
  const double left = grid.snap(rectangle[0]);
  const double right = grid.snap(rectangle[2]);
  if (!(left < right) || !(bottom < top))
    refuse(rectangle, no_area);

  const double height = grid.bed_joint(grid.n_courses());
  const bool begins_below = bottom < 0. && !grid.level_at(bottom);
  const bool ends_above = top > height && !grid.level_at(top);
  if (left < 0. || right > grid.width() || begins_below || ends_above)
    refuse(rectangle,
           text("is not inside the wall, which reaches from (0, 0) to ",
                text_of_point({grid.width(), height}), "."));

  const unsigned int first = find_level(grid, rectangle, false);
  const unsigned int end = find_level(grid, rectangle, true);
  if (first == end)
    refuse(rectangle, no_area);
  return {left, right, first, end};
}
} // namespace

std::vector<WallPart>
place_openings(WallGrid &grid,
               const std::vector<std::array<double, 4>> &rectangles)
{
  std::vector<WallPart> openings;
  for (const std::array<double, 4> &rectangle : rectangles)
  {
    const WallPart opening = place_opening(grid, rectangle);
    for (const WallPart &other : openings)
      if (opening.overlaps(other))
        refuse(rectangle, text("overlaps the ", describe(grid, other),
                               "; move one, or join them."));
    openings.push_back(opening);
  }
  return openings;
}

std::vector<WallPart> place_lintels(WallGrid &grid,
                                    const std::vector<WallPart> &openings,
                                    const double bearing)
{
  std::vector<WallPart> lintels;
  for (const WallPart &opening : openings)
  {
    const unsigned int course = opening.end_course;
    if (course == grid.n_courses())
      continue;
    const WallPart lintel = {
        grid.snap(std::max(0., opening.left - bearing)),
        grid.snap(std::min(grid.width(), opening.right + bearing)), course,
        course + 1};
    for (const WallPart &other : openings)
      if (lintel.overlaps(other))
        throw InputError(text("The lintel over the ", describe(grid, opening),
                              " in 'Packing/wall/Openings' would run into the ",
                              describe(grid, other),
                              "; move them apart, reduce 'Lintel bearing', or "
                              "set 'Lintels' to false."));
    lintels.push_back(lintel);
  }

  std::sort(lintels.begin(), lintels.end(),
            [](const WallPart &a, const WallPart &b) {
              return std::tie(a.first_course, a.left) <
                     std::tie(b.first_course, b.left);
            });
  std::vector<WallPart> merged;
  for (const WallPart &lintel : lintels)
    if (!merged.empty() && merged.back().overlaps(lintel))
      merged.back().right = std::max(merged.back().right, lintel.right);
    else
      merged.push_back(lintel);
  return merged;
}
} // namespace Voussoir
