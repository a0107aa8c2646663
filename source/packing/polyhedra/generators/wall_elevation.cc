// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/generators/wall_elevation.h>

#include <cmath>

namespace Voussoir
{
namespace
{
/** The width of the narrowest piece of a brick, over that of a brick. */
constexpr double narrowest_piece = 1. / 8.; // half a closer
} // namespace

WallElevation::WallElevation(const WallMeasures &wall,
                             const std::string &cause,
                             const std::string &advice)
    : CoursedWall({wall.length, wall.height, wall.n_courses, cause, 'z'}),
      measures(wall), advice(advice)
{
  const double n = std::round(wall.length / position(1));
  if (std::abs(n * position(1) - wall.length) <= resolution())
    quarters = static_cast<unsigned int>(n);
}

double WallElevation::narrowest() const
{
  return narrowest_piece * measures.brick_length;
}

std::optional<double> WallElevation::joint_near(const double x) const
{
  for (const WallInterval &run : measures.runs)
    for (const double end : {run.left, run.right})
      if (std::abs(x - end) <= resolution())
        return end;
  const double nearest = std::round(x / position(1));
  if (!(nearest >= 0. && nearest * position(1) <= measures.length))
    return {};
  const double joint = position(static_cast<unsigned int>(nearest));
  if (std::abs(x - joint) > resolution())
    return {};
  return joint;
}

void WallElevation::refuse_piece(const unsigned int course,
                                 const WallInterval &interval) const
{
  throw InputError(
      text(named_cause(), " leave a piece of wall from ",
           text_of_point({interval.left, bed_joint(course)}), " to ",
           text_of_point({interval.right, bed_joint(course + 1)}),
           " that is narrower than an eighth of a brick, which is ",
           narrowest(), "; ", advice));
}
} // namespace Voussoir
