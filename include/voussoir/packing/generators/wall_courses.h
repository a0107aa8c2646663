// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_wall_courses_h
#define voussoir_packing_generators_wall_courses_h

#include <voussoir/packing/generators/bond.h>
#include <voussoir/packing/generators/wall_openings.h>

#include <vector>

namespace Voussoir
{
/** One cell of a course; lengths. */
struct Stone
{
  /** @{ */
  /** The positions of its vertical sides; lengths. */
  double left, right;
  /** @} */
  /** True if it is a lintel, and not a brick. */
  bool is_lintel;
};

/** The stones of a course from left to right, with gaps at openings. */
using Course = std::vector<Stone>;

/**
 * Lay a course: the lintels in it, and between them and the openings bricks
 * with head joints where the bond has them. A brick that is cut to less than a
 * quarter of a header is joined to its neighbour, to a brick if there is one.
 *
 * @throws InputError if a brick that narrow has no neighbour.
 */
Course lay_course(const WallGrid &grid,
                  Bond bond,
                  unsigned int course,
                  const std::vector<WallPart> &openings,
                  const std::vector<WallPart> &lintels);
} // namespace Voussoir

#endif
