// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/generators/wall_grid.h>

#include <cmath>

namespace Voussoir
{
/**
 * The distance from a joint, relative to the size of the wall, at which a
 * number of the user still means it: ten digits are enough to name one.
 */
constexpr double relative_resolution = 1e-9;

std::optional<unsigned int> WallGrid::level_at(const double y) const
{
  const double nearest = std::round(y / total_height * courses);
  if (!(nearest >= 0. && nearest <= courses))
    return {};
  const auto level = static_cast<unsigned int>(nearest);
  if (std::abs(y - bed_joint(level)) > relative_resolution * total_height)
    return {};
  return level;
}

double WallGrid::snap(const double x)
{
  const unsigned int quarters = quarters_in_stretcher * stretchers;
  const double nearest = std::round(x / total_width * quarters);
  if (nearest >= 0. && nearest <= quarters)
  {
    const double joint = head_joint(static_cast<unsigned int>(nearest));
    if (std::abs(x - joint) <= resolution())
      return joint;
  }
  for (const double position : other_positions)
    if (std::abs(x - position) <= resolution())
      return position;
  other_positions.push_back(x);
  return x;
}

double WallGrid::resolution() const
{
  return relative_resolution * total_width;
}
} // namespace Voussoir
