// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/generators/wall_elevation.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Voussoir
{
namespace
{
/**
 * The distance from a joint, relative to the size of the wall, at which a
 * number of the user still means it: ten digits are enough to name one.
 */
constexpr double resolution_of_wall = 1e-9;

/** The width of the narrowest piece of a brick, over that of a brick. */
constexpr double narrowest_piece = 1. / 8.; // half a closer

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

WallElevation::WallElevation(const WallMeasures &wall,
                             const std::string &cause,
                             const std::string &advice)
    : measures(wall), cause(cause),
      advice(advice), inside{std::max(wall.runs[0].left, wall.runs[1].left),
                             std::min(wall.runs[0].right, wall.runs[1].right)}
{
  const double n = std::round(wall.length / position(1));
  if (std::abs(n * position(1) - wall.length) <= resolution())
    quarters = static_cast<unsigned int>(n);
}

double WallElevation::resolution() const
{
  return resolution_of_wall * measures.length;
}

double WallElevation::narrowest() const
{
  return narrowest_piece * measures.brick_length;
}

std::optional<unsigned int> WallElevation::level_at(const double z) const
{
  const double nearest = std::round(z / measures.height * measures.n_courses);
  if (!(nearest >= 0. && nearest <= measures.n_courses))
    return {};
  const auto level = static_cast<unsigned int>(nearest);
  if (std::abs(z - bed_joint(level)) > resolution_of_wall * measures.height)
    return {};
  return level;
}

double WallElevation::snap(const double x)
{
  for (const WallInterval &run : measures.runs)
    for (const double end : {run.left, run.right})
      if (std::abs(x - end) <= resolution())
        return end;
  const double nearest = std::round(x / position(1));
  if (nearest >= 0. && nearest * position(1) <= measures.length)
  {
    const double joint = position(static_cast<unsigned int>(nearest));
    if (std::abs(x - joint) <= resolution())
      return joint;
  }
  for (const double other : other_positions)
    if (std::abs(x - other) <= resolution())
      return other;
  other_positions.push_back(x);
  return x;
}

std::array<double, 4> WallElevation::rectangle_of(const WallPart &part) const
{
  return {{part.left, bed_joint(part.first_course), part.right,
           bed_joint(part.end_course)}};
}

void WallElevation::refuse_opening(const std::array<double, 4> &rectangle,
                                   const std::string &fault) const
{
  throw InputError("The " + text_of_opening(rectangle) + " in " + cause + ' ' +
                   fault);
}

void WallElevation::refuse_piece(const unsigned int course,
                                 const WallInterval &interval) const
{
  throw InputError(
      text(cause, " leave a piece of wall from ",
           text_of_point({interval.left, bed_joint(course)}), " to ",
           text_of_point({interval.right, bed_joint(course + 1)}),
           " that is narrower than an eighth of a brick, which is ",
           narrowest(), "; ", advice));
}

unsigned int WallElevation::find_level(const std::array<double, 4> &rectangle,
                                       const bool top) const
{
  const double z = rectangle[top ? 3 : 1];
  if (const auto level = level_at(z))
    return *level;
  const auto above =
      static_cast<unsigned int>(z / measures.height * n_courses()) + 1;
  refuse_opening(rectangle,
                 text("has its ", top ? "top" : "bottom", " at the height ",
                      text_to_copy(z),
                      ", which is not on a bed joint; the nearest are at ",
                      text_to_copy(bed_joint(above - 1)), " and ",
                      text_to_copy(bed_joint(above)), "."));
}

WallPart WallElevation::place_opening(const std::array<double, 4> &rectangle)
{
  const std::string no_area = "has no area; give \"x0, z0, x1, z1\" with "
                              "x0 < x1 and z0 < z1.";
  const double bottom = rectangle[1], top = rectangle[3];
  const double left = snap(rectangle[0]), right = snap(rectangle[2]);
  if (!(left < right) || !(bottom < top))
    refuse_opening(rectangle, no_area);

  const bool begins_below = bottom < 0. && !level_at(bottom);
  const bool ends_above = top > measures.height && !level_at(top);
  if (left < inside.left || right > inside.right || begins_below || ends_above)
    refuse_opening(rectangle,
                   text("is not inside the wall, which reaches from ",
                        text_of_point({inside.left, 0.}), " to ",
                        text_of_point({inside.right, measures.height}), "."));

  const unsigned int first = find_level(rectangle, false);
  const unsigned int end = find_level(rectangle, true);
  if (first == end)
    refuse_opening(rectangle, no_area);
  return {left, right, first, end};
}

std::vector<WallPart> WallElevation::place_openings(
    const std::vector<std::array<double, 4>> &rectangles)
{
  std::vector<WallPart> openings;
  for (const std::array<double, 4> &rectangle : rectangles)
  {
    const WallPart opening = place_opening(rectangle);
    for (const WallPart &other : openings)
      if (opening.overlaps(other))
        refuse_opening(rectangle, text("overlaps the ",
                                       text_of_opening(rectangle_of(other)),
                                       "; move one, or join them."));
    openings.push_back(opening);
  }
  return openings;
}

std::vector<WallPart>
WallElevation::place_lintels(const std::vector<WallPart> &openings,
                             const double bearing)
{
  std::vector<WallPart> lintels;
  for (const WallPart &opening : openings)
  {
    const unsigned int course = opening.end_course;
    if (course == n_courses())
      continue;
    const WallPart lintel = {
        snap(std::max(run(course).left, opening.left - bearing)),
        snap(std::min(run(course).right, opening.right + bearing)), course,
        course + 1};
    for (const WallPart &other : openings)
      if (lintel.overlaps(other))
        throw InputError(
            text("The lintel over the ", text_of_opening(rectangle_of(opening)),
                 " in ", cause, " would run into the ",
                 text_of_opening(rectangle_of(other)),
                 "; move them apart, reduce 'Lintel bearing', or set 'Lintels' "
                 "to false."));
    lintels.push_back(lintel);
  }
  return joined_lintels(std::move(lintels));
}
} // namespace Voussoir
