// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_kinematics_h
#define voussoir_algebra_kinematics_h

#include <deal.II/base/tensor.h>

#include <array>
#include <string>

namespace Voussoir
{

/** A joint as its two bodies see it; nondimensional. */
struct JointFrame
{
  /** n_e, from c- to c+. */
  dealii::Tensor<1, 2> normal;
  /** t_e = R(pi/2) n_e. */
  dealii::Tensor<1, 2> tangent;
  /** @{ */
  /** The ends of the joint, start and end along t_e, from the centre of a body.
   */
  std::array<dealii::Tensor<1, 2>, 2> from_minus;
  std::array<dealii::Tensor<1, 2>, 2> from_plus;
  /** @} */
};

/**
 * A contact row: the displacement of c+ relative to c-, at one point of a joint
 * and in one direction, as a linear form on the unknowns of the two bodies,
 *
 *     direction . (u_{c+} - u_{c-}) + turn_plus w_{c+} - turn_minus w_{c-},
 *
 * with u_c the first two unknowns of body c, and w_c the third if there is one.
 */
struct ContactRow
{
  /** The direction, of length one. */
  dealii::Tensor<1, 2> direction;
  /** @{ */
  /** The factor of the third unknown of c-, of c+. */
  double turn_minus = 0.;
  double turn_plus = 0.;
  /** @}*/
};

/**
 * The motions of a body: how many unknowns it has, two for its displacement and
 * possibly a third, which rows a joint has, and which motions are rigid.
 */
class Kinematics
{
public:
  virtual ~Kinematics() = default;
  /** The name, for the processes to agree on it; see kinematics_of(). */
  virtual std::string name() const = 0;
  /** The number of unknowns of a body, two or three. */
  virtual unsigned int n_unknowns() const = 0;
  /** The number of points in which the bodies of a joint touch. */
  virtual unsigned int n_contacts() const = 0;
  /** The rows of a joint: the normal one of each point, and a tangential one.*/
  unsigned int n_rows() const { return n_contacts() + 1; }
  /** Find the n_rows() @p rows of a joint, the tangential one at last. */
  virtual void find_rows(const JointFrame &joint, ContactRow *rows) const = 0;
  /**
   * The number of motions of all bodies as one. In motion k a body at the
   * origin has unknown k equal to one and no other.
   */
  virtual unsigned int n_rigid_motions() const = 0;
  /** The unknowns of a body at @p x in motion @p k. */
  virtual void find_rigid_motion(unsigned int k,
                                 const dealii::Tensor<1, 2> &x,
                                 double *unknowns) const = 0;
};

/** Bodies that do not turn, and touch at the midpoint of a joint. */
const Kinematics &translations();
/**
 * Bodies that also turn. The third unknown is the angle about x_c, positive
 * counterclockwise, times the unit of length, and bodies touch at both ends of
 * a joint: contact there is contact all along it, since the opening of a joint
 * is linear. Its sliding is the same everywhere, (x - x_c) . n_e being
 * constant.
 */
const Kinematics &rotations();

/** The kinematics of that name among those that there are. */
const Kinematics &kinematics_of(const std::string &name);

} // namespace Voussoir

#endif
