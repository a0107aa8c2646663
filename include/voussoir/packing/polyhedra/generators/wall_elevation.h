// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_generators_wall_elevation_h
#define voussoir_packing_polyhedra_generators_wall_elevation_h

#include <voussoir/packing/generators/wall_openings.h>
#include <voussoir/packing/polyhedra/generators/wall_bond.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** A part of the length of a wall. */
struct WallInterval
{
  /** The position where it begins; a length. */
  double left;
  /** The position where it ends; a length. */
  double right;
};

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

/**
 * A wall as it is seen from the front: the places of its joints, openings and
 * lintels; lengths. Every position is computed here, so that positions that are
 * meant to be equal are so to the last bit.
 */
class WallElevation
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

  /** The number of courses. */
  unsigned int n_courses() const { return measures.n_courses; }
  /** The height of a bed joint, 0 below the first course; a length. */
  double bed_joint(const unsigned int level) const
  {
    return measures.height * level / measures.n_courses;
  }
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
  /** The bed joint at the height @p z, if there is one. */
  std::optional<unsigned int> level_at(double z) const;

  /**
   * The position that agrees with @p x: of a quarter of a brick, of an end of a
   * course, of an earlier call, or @p x itself. Lengths.
   */
  double snap(double x);

  /** The distance below which positions are the same; a length. */
  double resolution() const;
  /** The width of a piece of a brick, at least; a length. */
  double narrowest() const;

  /**
   * The openings, each given by the lower left corner x0, z0 and the upper
   * right one x1, z1; lengths.
   *
   * @throws InputError if one has no area, is not inside all courses, does not
   *   begin and end on bed joints or overlaps another.
   */
  std::vector<WallPart>
  place_openings(const std::vector<std::array<double, 4>> &rectangles);

  /**
   * The lintels over all openings below the top of the wall: one course high,
   * resting on the wall over the length @p bearing on either side, or up to the
   * end of the course. Lintels that would overlap are one.
   *
   * @throws InputError if a lintel would run into an opening.
   */
  std::vector<WallPart> place_lintels(const std::vector<WallPart> &openings,
                                      double bearing);

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

private:
  [[noreturn]] void refuse_opening(const std::array<double, 4> &rectangle,
                                   const std::string &fault) const;
  WallPart place_opening(const std::array<double, 4> &rectangle);
  unsigned int find_level(const std::array<double, 4> &rectangle,
                          bool top) const;
  std::array<double, 4> rectangle_of(const WallPart &part) const;

  WallMeasures measures;
  std::string cause, advice;
  /** What all courses fill. */
  WallInterval inside;
  std::optional<unsigned int> quarters;
  std::vector<double> other_positions;
};
} // namespace Voussoir

#endif
