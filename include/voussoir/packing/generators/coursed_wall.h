// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_generators_coursed_wall_h
#define voussoir_packing_generators_coursed_wall_h

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
 * A wall of courses of one height as it is seen from the front: the places of
 * its bed joints, openings and lintels; lengths. Every position is computed
 * here, so that positions that are meant to be equal are so to the last bit.
 */
class CoursedWall
{
public:
  virtual ~CoursedWall() = default;

  /** The number of courses. */
  unsigned int n_courses() const { return courses; }
  /** The height of a bed joint, 0 below the first course; a length. */
  double bed_joint(const unsigned int level) const
  {
    return height * level / courses;
  }
  /** The bed joint at a height above the foot, if there is one. */
  std::optional<unsigned int> level_at(double above_foot) const;

  /**
   * The position that agrees with @p x: of a joint, of an earlier call, or
   * @p x itself. Lengths.
   */
  double snap(double x);

  /** The distance below which positions are the same; a length. */
  double resolution() const;

  /**
   * Place openings, each given by its lower left corner and its upper right
   * one; lengths.
   *
   * @throws InputError if one has no area, is not inside all courses, does not
   *   begin and end on bed joints or overlaps another.
   */
  std::vector<WallPart>
  place_openings(const std::vector<std::array<double, 4>> &rectangles);

  /**
   * Place lintels over all openings below the top of the wall: one course
   * high, resting on the wall over the length @p bearing on either side, or up
   * to the end of the course. Lintels that would overlap are one.
   *
   * @throws InputError if a lintel would run into an opening.
   */
  std::vector<WallPart> place_lintels(const std::vector<WallPart> &openings,
                                      double bearing);

protected:
  /** The measures of a wall, and what messages call it. */
  struct Front
  {
    /** The length, from the position 0 on; positive. */
    double length;
    /** The height, from 0 on; a length, positive. */
    double height;
    /** The number of courses, all of one height. */
    unsigned int n_courses;
    /** The entries that a message on a place names first: "'A' and 'B'". */
    std::string cause;
    /** The axis that points up, as openings are given: y or z. */
    char upwards;
  };

  /** A wall that is to be used through the classes that know its bricks. */
  explicit CoursedWall(const Front &front);

  /** The joint nearest to @p x that is within the resolution, if any is. */
  virtual std::optional<double> joint_near(double x) const = 0;
  /** What a course fills of the length, with its openings; as all even or odd
   * ones. */
  virtual WallInterval filled(unsigned int course) const = 0;
  /** What messages name first. */
  const std::string &named_cause() const { return cause; }

private:
  [[noreturn]] void refuse_opening(const std::array<double, 4> &rectangle,
                                   const std::string &fault) const;
  WallPart place_opening(const std::array<double, 4> &rectangle);
  unsigned int find_level(const std::array<double, 4> &rectangle,
                          bool top) const;
  /** What all courses fill. */
  WallInterval inside() const;
  /** The opening as messages name it. */
  std::string describe(const WallPart &opening) const;

  double length, height;
  unsigned int courses;
  std::string cause;
  char upwards;
  std::vector<double> other_positions;
};
} // namespace Voussoir

#endif
