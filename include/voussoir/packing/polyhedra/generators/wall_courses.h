// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_wall_courses_h
#define voussoir_packing_polyhedra_generators_wall_courses_h

#include <voussoir/packing/polyhedra/generators/wall_elevation.h>

#include <vector>

namespace Voussoir
{
/** What a course of a wall is made of; each from left to right. */
struct WallCourse
{
  /** The parts that are laid in bricks. */
  std::vector<WallInterval> gaps;
  /** The lintels, of one block each. */
  std::vector<WallInterval> lintels;
};

/**
 * Divide a course. Where less than WallElevation::narrowest() is left beside a
 * lintel, the lintel fills it.
 *
 * @throws InputError if less than that is left without a lintel beside it.
 */
WallCourse divide_course(const WallElevation &wall,
                         unsigned int course,
                         const std::vector<WallPart> &openings,
                         const std::vector<WallPart> &lintels);

/** One or more bricks side by side, between two head joints of a row. */
struct WallStone
{
  /** The position where it begins; a length. */
  double left;
  /** The position where it ends; a length. */
  double right;
  /** The number of bricks side by side across the row. */
  unsigned int n_across;
};

/**
 * Lay a row of bricks in a gap, from left to right. A brick that the end of the
 * gap cuts to less than WallElevation::narrowest() is joined to its neighbour.
 */
std::vector<WallStone> lay_row(const WallElevation &wall,
                               const RowPattern &pattern,
                               const WallInterval &gap);
} // namespace Voussoir

#endif
