// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_wall_bond_h
#define voussoir_packing_polyhedra_generators_wall_bond_h

#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * The overlap of the bricks of a wall, along it and through its thickness. The
 * thickness is counted in widths of bricks. A stretcher lies along the wall; a
 * header lies across it and is as deep as two stretchers side by side, where
 * there are both; a closer is half as wide as a header. Courses are counted
 * from 0 at the bottom.
 */
enum class WallBond
{
  /** Leaves of stretchers side by side; every odd course is shifted by half a
   * stretcher, with a half bat at either end. */
  running,
  /** Leaves of stretchers, with all head joints above each other. */
  stack,
  /** Headers; every odd course is shifted by half of one. */
  header,
  /**
   * Even courses with stretchers in front, odd ones with headers in front; what
   * is behind is laid in headers, and in stretchers at the back where one brick
   * width is left over, so that no joint between rows is above another. Rows of
   * headers in odd courses have a closer next to the first header, and next to
   * the last if the wall is a whole number of stretchers long. In a wall
   * thicker than two brick widths the joints beside these headers are above
   * each other inside the wall.
   */
  English,
  /**
   * In a wall two brick widths thick, two stretchers side by side and a header
   * alternate in each course. Even courses begin with stretchers; odd ones with
   * a header and a closer, and end so if the wall is 1, 5/2, 4, 11/2, ...
   * stretchers long, for which even courses end with stretchers.
   */
  Flemish
};

/** Positions along a wall are counted in quarters of a stretcher. */
constexpr unsigned int quarters_of_brick = 4;

/** Where the head joints of a row of bricks are, and what is between them. */
struct RowPattern
{
  /** A joint, and the bricks behind it. */
  struct Joint
  {
    /** The position within a period, less than it; in quarters. */
    unsigned int at;
    /** The number of bricks side by side across the row up to the next joint.*/
    unsigned int n_across;
  };

  /** The distance after which the pattern repeats itself; in quarters. */
  unsigned int period;
  /** The joints of one period, by ascending position. */
  std::vector<Joint> joints;
  /** A header and a closer at the ends of a row, one brick across. */
  struct Closers
  {
    /** @{ */
    /**
     * They are also at the right end if the length of the wall, in quarters,
     * has this remainder modulo the other number.
     */
    unsigned int remainder;
    unsigned int modulo;
    /** @} */
  };
  /** Those that the row begins with, if it does. */
  std::optional<Closers> closers = {};

  /**
   * True if there is a joint at @p quarter.
   *
   * @param length of the wall in quarters, if it is a whole number of them.
   */
  bool is_joint(unsigned int quarter, std::optional<unsigned int> length) const;

  /** The number of bricks side by side at @p quarter, which is at no joint. */
  unsigned int n_across(double quarter,
                        std::optional<unsigned int> length) const;

private:
  bool is_regular_joint(unsigned int quarter) const;
  bool ends_with_closer(std::optional<unsigned int> length) const;
};

/** One of the rows that lie one behind the other in a course. */
struct BondRow
{
  /** Where it begins, in brick widths from the front. */
  unsigned int front;
  /** Where it ends, in brick widths from the front. */
  unsigned int back;
  /** Its joints. */
  RowPattern pattern;
};

/**
 * The rows of a course, from the front to the back.
 *
 * @param n_widths the thickness of the wall in brick widths: 2 for Flemish, at
 *   least 2 for English and an even number for header bond.
 */
std::vector<BondRow>
rows_of_course(WallBond bond, unsigned int course, unsigned int n_widths);
} // namespace Voussoir

#endif
