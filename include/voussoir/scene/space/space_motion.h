// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_space_space_motion_h
#define voussoir_scene_space_space_motion_h

#include <voussoir/algebra/kinematics.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Voussoir
{
/** How a support in space moves: as a rigid body, to first order in angles. */
struct SpaceSupportMotion
{
  /** Of its centroid; L. */
  dealii::Tensor<1, 3> displacement;
  /** The vector of the angle about it. */
  dealii::Tensor<1, 3> rotation;

  /** The displacement at @p arm from its centroid. */
  dealii::Tensor<1, 3> at(const dealii::Tensor<1, 3> &arm) const
  {
    return displacement + cross_product_3d(rotation, arm);
  }
};

/** A motion of the cells in space, of any size. */
struct SpaceMotion
{
  /** No motion. */
  SpaceMotion() = default;
  /** One of rest. */
  SpaceMotion(const unsigned int n_cells, const Kinematics &kinematics)
      : displacement(n_cells), rotation(kinematics.turns() ? n_cells : 0)
  {}
  /**
   * The displacement of cell @p c at @p arm from its centre, to first order in
   * the angle.
   */
  dealii::Tensor<1, 3> at(const unsigned int c,
                          const dealii::Tensor<1, 3> &arm) const
  {
    return rotation.empty()
               ? displacement[c]
               : displacement[c] + cross_product_3d(rotation[c], arm);
  }

  /** u_c of each cell, at its centre x_c. */
  std::vector<dealii::Tensor<1, 3>> displacement;
  /**
   * The vector of the angle of each cell, in the unit of u_c over one of
   * length; empty where cells do not turn.
   */
  std::vector<dealii::Tensor<1, 3>> rotation;
  /**
   * Of each support, in the order of the last Packing::n_supports() interfaces;
   * empty where the ground is at rest.
   */
  std::vector<SpaceSupportMotion> of_supports;
};
} // namespace Voussoir

#endif
