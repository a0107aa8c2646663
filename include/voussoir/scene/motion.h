// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_motion_h
#define voussoir_scene_motion_h

#include <voussoir/algebra/kinematics.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Voussoir
{

/** How a support moves: as a rigid body, to first order in the angle. */
struct SupportMotion
{
  /** Of its midpoint; L. */
  dealii::Tensor<1, 2> displacement;
  /** The angle about it, positive counterclockwise. */
  double rotation = 0.;

  /** The displacement at @p arm from its midpoint. */
  dealii::Tensor<1, 2> at(const dealii::Tensor<1, 2> &arm) const
  {
    dealii::Tensor<1, 2> u = displacement;
    u[0] -= rotation * arm[1];
    u[1] += rotation * arm[0];
    return u;
  }
};

/** A motion of the cells, of any size; the ground does not move. */
struct Motion
{
  /** No motion. */
  Motion() = default;
  /** One of rest. */
  Motion(const unsigned int n_cells, const Kinematics &kinematics)
      : displacement(n_cells), rotation(kinematics.turns() ? n_cells : 0, 0.)
  {}
  /**
   * The displacement of cell @p c at @p arm from its centre, to first order in
   * the angle.
   */
  dealii::Tensor<1, 2> at(const unsigned int c,
                          const dealii::Tensor<1, 2> &arm) const
  {
    dealii::Tensor<1, 2> u = displacement[c];
    if (!rotation.empty())
    {
      u[0] -= rotation[c] * arm[1];
      u[1] += rotation[c] * arm[0];
    }
    return u;
  }

  /** u_c of each cell, at its centre x_c. */
  std::vector<dealii::Tensor<1, 2>> displacement;
  /**
   * The angle of each cell, positive counterclockwise, in the unit of u_c over
   * one of length; empty where cells do not turn.
   */
  std::vector<double> rotation;
  /**
   * Of each support, in the order of the last Packing::n_supports() interfaces;
   * empty where the ground is at rest.
   */
  std::vector<SupportMotion> of_supports;
};

/** A motion in the plane or in space that is @p factor times as large. */
template <typename MotionOfBlocks>
MotionOfBlocks times(MotionOfBlocks motion, const double factor)
{
  for (auto &u : motion.displacement)
    u *= factor;
  for (auto &angle : motion.rotation)
    angle *= factor;
  for (auto &of : motion.of_supports)
  {
    of.displacement *= factor;
    of.rotation *= factor;
  }
  return motion;
}

} // namespace Voussoir

#endif
