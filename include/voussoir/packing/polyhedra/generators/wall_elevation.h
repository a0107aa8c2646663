// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_wall_elevation_h
#define voussoir_packing_polyhedra_generators_wall_elevation_h

#include <voussoir/packing/generators/coursed_wall.h>
#include <voussoir/packing/polyhedra/generators/wall_bond.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** The measures of a wall as it is seen from the front. */
struct WallMeasures
{
  /** The length, from the position 0 on; positive. */
  double length;
  /** The height, from 0 on; a length, positive. */
  double height;
  /** The number of courses, all of one height. */
  unsigned int n_courses;
  /** The length of a brick that is not cut; positive. */
  double brick_length;
  /** What even and odd courses fill of the length. */
  std::array<WallInterval, 2> runs;
};

/** A wall in space as it is seen from the front, with its bricks' joints. */
class WallElevation : public CoursedWall
{
public:
  /**
   * @param cause the entries that a message on a place names first: "'A' and
   *   'B'".
   * @param advice the end of the message on a piece that is too narrow.
   */
  WallElevation(const WallMeasures &measures,
                const std::string &cause,
                const std::string &advice);

  /** A position in quarters of a brick; a length. */
  double position(const unsigned int quarter) const
  {
    return measures.brick_length * quarter / quarters_of_brick;
  }
  /** What a course fills of the length of the wall, with its openings. */
  const WallInterval &run(const unsigned int course) const
  {
    return measures.runs[course % 2];
  }

  /** The width of a piece of a brick, at least; a length. */
  double narrowest() const;

  /** The length in quarters of a brick, if it is a whole number of them. */
  std::optional<unsigned int> n_quarters() const { return quarters; }

  /** True if a piece of a brick cannot be as narrow as @p interval. */
  bool is_too_narrow(const WallInterval &interval) const
  {
    return interval.right - interval.left < narrowest() - resolution();
  }

  /** @throws InputError: a piece of a course is too narrow. */
  [[noreturn]] void refuse_piece(unsigned int course,
                                 const WallInterval &interval) const;

protected:
  std::optional<double> joint_near(double x) const override;
  WallInterval filled(const unsigned int course) const override
  {
    return run(course);
  }

private:
  WallMeasures measures;
  std::string advice;
  std::optional<unsigned int> quarters;
};
} // namespace Voussoir

#endif
