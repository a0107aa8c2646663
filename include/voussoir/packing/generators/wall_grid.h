// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_wall_grid_h
#define voussoir_packing_generators_wall_grid_h

#include <voussoir/packing/generators/bond.h>

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
  WallGrid(const double width,
           const double height,
           const unsigned int n_courses,
           const unsigned int n_stretchers)
      : total_width(width), total_height(height), courses(n_courses),
        stretchers(n_stretchers)
  {}

  /** The number of courses, the height of the wall in bricks. */
  unsigned int n_courses() const { return courses; }
  /** The number of stretchers, the width of the wall in bricks. */
  unsigned int n_stretchers() const { return stretchers; }
  /** The width of the wall; a length. */
  double width() const
  {
    return head_joint(quarters_in_stretcher * stretchers);
  }
  /** The height of a bed joint, 0 below the first course; a length. */
  double bed_joint(const unsigned int level) const
  {
    return total_height * level / courses;
  }
  /** A position of head joints, in quarters of a stretcher; a length. */
  double head_joint(const unsigned int quarter) const
  {
    return total_width * quarter / (quarters_in_stretcher * stretchers);
  }
  /** The bed joint at the height @p y, if there is one. */
  std::optional<unsigned int> level_at(double y) const;

  /**
   * The position that agrees with @p x: of a head joint, of an earlier call, or
   * @p x itself. Lengths.
   */
  double snap(double x);

  /** The distance below which positions are the same; a length. */
  double resolution() const;

private:
  double total_width, total_height;
  unsigned int courses, stretchers;
  std::vector<double> other_positions;
};
} // namespace Voussoir

#endif
