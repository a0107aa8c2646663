// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_bond_h
#define voussoir_packing_generators_bond_h

#include <vector>

namespace Voussoir
{
/**
 * The overlap of the bricks of a wall, seen from the front. A stretcher shows
 * its length, a header half of that, a closer a quarter; a bat is a brick cut
 * short. Courses are counted from 0 at the bottom.
 */
enum class Bond
{
  /** Stretchers; every odd course is shifted by half of one, with a half bat
   * at either end. */
  running,
  /** Stretchers, with all head joints above each other. */
  stack,
  /** Even courses of stretchers; odd courses of headers, with a closer next to
   * the header at either end. */
  English,
  /**
   * Stretcher and header alternate in each course. Even courses begin with a
   * stretcher; odd ones with a header and a closer, so that all other headers
   * are centred over the stretchers below. The right end is the mirror image
   * of the left one if the wall is 1, 4, 7, ... stretchers long; otherwise it
   * cuts the pattern.
   */
  Flemish
};

/** Head joints lie on quarters of a stretcher. */
constexpr unsigned int quarters_in_stretcher = 4;

/**
 * The head joints of a course of a wall @p n_stretchers long, from left to
 * right with both ends of the wall among them, in quarters of a stretcher. In
 * no bond but the stack bond is one above another of the course below.
 */
std::vector<unsigned int>
head_joints(Bond bond, unsigned int course, unsigned int n_stretchers);
} // namespace Voussoir

#endif
