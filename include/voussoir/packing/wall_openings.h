// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_wall_openings_h
#define voussoir_packing_wall_openings_h

#include <array>
#include <optional>
#include <vector>

namespace Voussoir
{
/**
 * The lines on which the joints of a rectangular wall lie. Its lower left
 * corner is the origin. Every position is computed here, so that positions
 * that are meant to be equal are so to the last bit.
 */
class WallGrid
{
public:
  /** @param width, height lengths. */
  WallGrid(double width,
           double height,
           unsigned int n_courses,
           unsigned int n_stretchers);

  unsigned int n_courses() const;
  unsigned int n_stretchers() const;
  /** The width of the wall; a length. */
  double width() const;
  /** The height of a bed joint, 0 below the first course; a length. */
  double bed_joint(unsigned int level) const;
  /** The position of a head joint at @p quarter stretchers; a length. */
  double head_joint(unsigned int quarter) const;
  /** The bed joint at the height @p y, if there is one. */
  std::optional<unsigned int> level_at(double y) const;

  /**
   * The position that agrees with @p x: of a head joint, of an earlier call, or
   * @p x itself. Lengths.
   */
  double snap(double x);

  /** Positions nearer to each other than this are one; a length. */
  double resolution() const;

private:
  double total_width, total_height;
  unsigned int courses, stretchers;
  std::vector<double> other_positions;
};

/** A rectangle of a wall; lengths, and courses from the first to before end. */
struct WallPart
{
  double left, right;
  unsigned int first_course, end_course;

  bool overlaps(const WallPart &other) const;
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
