// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/generators/wall_grid.h>

#include <cmath>

namespace Voussoir
{
std::optional<double> WallGrid::joint_near(const double x) const
{
  const unsigned int quarters = quarters_in_stretcher * stretchers;
  const double nearest = std::round(x / total_width * quarters);
  if (!(nearest >= 0. && nearest <= quarters))
    return {};
  const double joint = head_joint(static_cast<unsigned int>(nearest));
  if (std::abs(x - joint) > resolution())
    return {};
  return joint;
}
} // namespace Voussoir
