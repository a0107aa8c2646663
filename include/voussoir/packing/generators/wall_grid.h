// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_wall_grid_h
#define voussoir_packing_generators_wall_grid_h

#include <voussoir/packing/generators/bond.h>
#include <voussoir/packing/generators/coursed_wall.h>

#include <optional>

namespace Voussoir
{
/**
 * The lines on which the joints of a rectangular wall lie. Its lower left
 * corner is the origin.
 */
class WallGrid : public CoursedWall
{
public:
  /** @param width, height lengths. */
  WallGrid(const double width,
           const double height,
           const unsigned int n_courses,
           const unsigned int n_stretchers)
      : CoursedWall({width, height, n_courses, "'Packing/wall/Openings'", 'y'}),
        total_width(width), stretchers(n_stretchers)
  {}

  /** The number of stretchers, the width of the wall in bricks. */
  unsigned int n_stretchers() const { return stretchers; }
  /** The width of the wall; a length. */
  double width() const
  {
    return head_joint(quarters_in_stretcher * stretchers);
  }
  /** A position of head joints, in quarters of a stretcher; a length. */
  double head_joint(const unsigned int quarter) const
  {
    return total_width * quarter / (quarters_in_stretcher * stretchers);
  }

protected:
  std::optional<double> joint_near(double x) const override;
  WallInterval filled(unsigned int) const override { return {0., width()}; }

private:
  double total_width;
  unsigned int stretchers;
};
} // namespace Voussoir

#endif
