// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_joint_rows_h
#define voussoir_algebra_joint_rows_h

#include <voussoir/algebra/kinematics.h>

#include <cstddef>
#include <vector>

namespace Voussoir
{
/** An interface e; nondimensional. */
struct Joint
{
  /** c-, the number of a body here. */
  unsigned int cell_minus;
  /** c+, the number of a body here; possibly the ground. */
  unsigned int cell_plus;
  /** |e|, the length, or in space the area. */
  double length;
  /** d_e, which is positive; see Packing::distance(). */
  double distance;
  /** s_e |e|, the strength. With Coulomb's friction c_e |e|. */
  double strength;
  /** mu_e, which Coulomb's friction adds times the compression. */
  double coefficient = 0.;
  /** k_e = |e| / d_e, of a joint with modulus one. */
  double stiffness() const { return length / distance; }
  /**
   * The part of that along the joint in space that each of its two kinds of
   * sets has: all of it, or half where cones of friction and discs share it.
   */
  double tangential_part() const
  {
    return coefficient > 0. && strength > 0. ? 0.5 : 1.;
  }
};

/** A set of rows of a joint in space. */
struct FaceSet
{
  /** 1: a pressure. 3: a pressure with its friction. 2: a disc of friction. */
  unsigned int size;
  /** @{ */
  /** Its first row and coefficient, counted from the first of the joint. */
  unsigned int row, coefficient;
  /** @} */
  /** The part of the stiffness of the joint, or of its limits, that it has. */
  double share;
  /** Of a disc. */
  double strength;
};

/**
 * All joints of a structure with their rows, see ContactRow, and the sets that
 * these come in, see Structure.
 */
struct JointRows
{
  /** The joints. */
  std::vector<Joint> list;
  /** The number of the first row of each joint, and at last of all rows. */
  std::vector<unsigned int> first_row = {0};
  /** ContactRow::direction of each row, n_translations() numbers each. */
  std::vector<double> direction;
  /** @{ */
  /** Of each row, n_rotations() numbers each. */
  std::vector<double> turn_minus, turn_plus;
  /** @} */
  /**
   * The number of rows of each set of all joints, in their order; empty where
   * each set is one row.
   */
  std::vector<unsigned int> set_sizes;
  /** @{ */
  /**
   * The numbers of the first set and of the first coefficient of each joint,
   * and at last of all; empty where each set is one row.
   */
  std::vector<unsigned int> first_set;
  std::vector<unsigned int> first_coefficient;
  /** @} */
  /**
   * In space the share of each set of all joints in the stiffness of its joint,
   * and if it has two rows in the strength; empty in the plane.
   */
  std::vector<double> shares;
  /**
   * In space the strength of each set of all joints, which counts if it has two
   * rows; empty where that is its share in the strength of its joint.
   */
  std::vector<double> set_strengths;
  /**
   * Add a joint.
   *
   * @param joint without its rows.
   * @param rows of the joint.
   * @param kinematics of the bodies.
   * @param sets the numbers of rows of its sets; empty if each is one row.
   * @param shares_of_sets in space, one for each of the sets.
   */
  void add(const Joint &joint,
           const std::vector<ContactRow> &rows,
           const Kinematics &kinematics,
           const std::vector<unsigned int> &sets = {},
           const std::vector<double> &shares_of_sets = {});
  /** Make room for @p n_joints with @p n_rows rows in all. */
  void reserve(std::size_t n_joints,
               std::size_t n_rows,
               const Kinematics &kinematics);

private:
  void add_sets(const std::vector<unsigned int> &sets, std::size_t n_rows);
};
} // namespace Voussoir

#endif
