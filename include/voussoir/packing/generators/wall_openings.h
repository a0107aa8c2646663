// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_wall_openings_h
#define voussoir_packing_generators_wall_openings_h

#include <voussoir/packing/generators/wall_grid.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** A rectangle of a wall, from bed joint to bed joint. */
struct WallPart
{
  double left;               /**< the position of that side; a length */
  double right;              /**< the position of that side; a length */
  unsigned int first_course; /**< the lowest */
  unsigned int end_course;   /**< one above the highest */

  /** True if they have more than a side in common. */
  bool overlaps(const WallPart &other) const
  {
    return left < other.right && other.left < right &&
           first_course < other.end_course && other.first_course < end_course;
  }
};

/**
 * Openings of a wall, each given by the lower left corner x0, y0 and the upper
 * right one x1, y1; lengths.
 *
 * @throws InputError if one has no area, is not inside the wall, does not begin
 *   and end on bed joints or overlaps another.
 */
std::vector<WallPart>
place_openings(WallGrid &grid,
               const std::vector<std::array<double, 4>> &rectangles);

/**
 * The lintels over all openings below the top of the wall: one course high,
 * resting on the wall over the length @p bearing on either side, or up to the
 * end of the wall. Lintels that would overlap are one.
 *
 * @throws InputError if a lintel would run into an opening.
 */
std::vector<WallPart> place_lintels(WallGrid &grid,
                                    const std::vector<WallPart> &openings,
                                    double bearing);
} // namespace Voussoir

#endif
