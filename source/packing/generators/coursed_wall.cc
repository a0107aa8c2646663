// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/generators/coursed_wall.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The distance from a joint, relative to the size of the wall, at which a
 * number of the user still means it: ten digits are enough to name one.
 */
constexpr double resolution_of_wall = 1e-9;

std::string text_of_opening(const std::array<double, 4> &rectangle)
{
  return text("opening from ", text_of_point({rectangle[0], rectangle[1]}),
              " to ", text_of_point({rectangle[2], rectangle[3]}));
}

/** The lintels, joined where they overlap, from the bottom and the left. */
std::vector<WallPart> joined_lintels(std::vector<WallPart> lintels)
{
  std::sort(lintels.begin(), lintels.end(),
            [](const WallPart &a, const WallPart &b) {
              return std::tie(a.first_course, a.left) <
                     std::tie(b.first_course, b.left);
            });
  std::vector<WallPart> joined;
  for (const WallPart &lintel : lintels)
    if (!joined.empty() && joined.back().overlaps(lintel))
      joined.back().right = std::max(joined.back().right, lintel.right);
    else
      joined.push_back(lintel);
  return joined;
}
} // namespace

CoursedWall::CoursedWall(const Front &front)
    : length(front.length), height(front.height), courses(front.n_courses),
      cause(front.cause), upwards(front.upwards)
{}

double CoursedWall::resolution() const
{
  return resolution_of_wall * length;
}

std::optional<unsigned int> CoursedWall::level_at(const double above_foot) const
{
  const double nearest = std::round(above_foot / height * courses);
  if (!(nearest >= 0. && nearest <= courses))
    return {};
  const auto level = static_cast<unsigned int>(nearest);
  if (std::abs(above_foot - bed_joint(level)) > resolution_of_wall * height)
    return {};
  return level;
}

double CoursedWall::snap(const double x)
{
  if (const std::optional<double> joint = joint_near(x))
    return *joint;
  for (const double position : other_positions)
    if (std::abs(x - position) <= resolution())
      return position;
  other_positions.push_back(x);
  return x;
}

WallInterval CoursedWall::inside() const
{
  const WallInterval even = filled(0), odd = filled(1);
  return {std::max(even.left, odd.left), std::min(even.right, odd.right)};
}

std::string CoursedWall::describe(const WallPart &opening) const
{
  return text_of_opening({{opening.left, bed_joint(opening.first_course),
                           opening.right, bed_joint(opening.end_course)}});
}

void CoursedWall::refuse_opening(const std::array<double, 4> &rectangle,
                                 const std::string &fault) const
{
  throw InputError("The " + text_of_opening(rectangle) + " in " + cause + ' ' +
                   fault);
}

unsigned int CoursedWall::find_level(const std::array<double, 4> &rectangle,
                                     const bool top) const
{
  const double at = rectangle[top ? 3 : 1];
  if (const auto level = level_at(at))
    return *level;
  const auto above = static_cast<unsigned int>(at / height * courses) + 1;
  refuse_opening(rectangle,
                 text("has its ", top ? "top" : "bottom", " at the height ",
                      text_to_copy(at),
                      ", which is not on a bed joint; the nearest are at ",
                      text_to_copy(bed_joint(above - 1)), " and ",
                      text_to_copy(bed_joint(above)), "."));
}

WallPart CoursedWall::place_opening(const std::array<double, 4> &rectangle)
{
  const std::string no_area =
      text("has no area; give \"x0, ", upwards, "0, x1, ", upwards,
           "1\" with x0 < x1 and ", upwards, "0 < ", upwards, "1.");
  const double bottom = rectangle[1], top = rectangle[3];
  const double left = snap(rectangle[0]), right = snap(rectangle[2]);
  if (!(left < right) || !(bottom < top))
    refuse_opening(rectangle, no_area);

  const bool begins_below = bottom < 0. && !level_at(bottom);
  const bool ends_above = top > height && !level_at(top);
  const WallInterval of_all = inside();
  if (left < of_all.left || right > of_all.right || begins_below || ends_above)
    refuse_opening(rectangle,
                   text("is not inside the wall, which reaches from ",
                        text_of_point({of_all.left, 0.}), " to ",
                        text_of_point({of_all.right, height}), "."));

  const unsigned int first = find_level(rectangle, false);
  const unsigned int end = find_level(rectangle, true);
  if (first == end)
    refuse_opening(rectangle, no_area);
  return {left, right, first, end};
}

std::vector<WallPart> CoursedWall::place_openings(
    const std::vector<std::array<double, 4>> &rectangles)
{
  std::vector<WallPart> openings;
  for (const std::array<double, 4> &rectangle : rectangles)
  {
    const WallPart opening = place_opening(rectangle);
    for (const WallPart &other : openings)
      if (opening.overlaps(other))
        refuse_opening(rectangle, text("overlaps the ", describe(other),
                                       "; move one, or join them."));
    openings.push_back(opening);
  }
  return openings;
}

std::vector<WallPart>
CoursedWall::place_lintels(const std::vector<WallPart> &openings,
                           const double bearing)
{
  std::vector<WallPart> lintels;
  for (const WallPart &opening : openings)
  {
    const unsigned int course = opening.end_course;
    if (course == courses)
      continue;
    const WallInterval of_course = filled(course);
    const WallPart lintel = {
        snap(std::max(of_course.left, opening.left - bearing)),
        snap(std::min(of_course.right, opening.right + bearing)), course,
        course + 1};
    for (const WallPart &other : openings)
      if (lintel.overlaps(other))
        throw InputError(
            text("The lintel over the ", describe(opening), " in ", cause,
                 " would run into the ", describe(other),
                 "; move them apart, reduce 'Lintel bearing', or set 'Lintels' "
                 "to false."));
    lintels.push_back(lintel);
  }
  return joined_lintels(std::move(lintels));
}
} // namespace Voussoir
