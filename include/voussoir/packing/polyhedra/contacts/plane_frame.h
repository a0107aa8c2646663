// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_plane_frame_h
#define voussoir_packing_polyhedra_contacts_plane_frame_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>

namespace Voussoir
{
/**
 * Coordinates in a plane, and heights above it. The two axes and the normal
 * are orthonormal and right-handed; where the normal is an axis of space, so
 * are they, and coordinates are exact differences.
 */
class PlaneFrame
{
public:
  /**
   * @param origin the place of the coordinates zero, near what they describe.
   * @param normal a unit vector.
   */
  PlaneFrame(const dealii::Point<3> &origin, const dealii::Tensor<1, 3> &normal)
      : start(origin), up(normal)
  {
    unsigned int least = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(up[d]) < std::abs(up[least]))
        least = d;
    across[0][least] = 1.;
    across[0] -= up[least] * up;
    across[0] /= across[0].norm();
    across[1] = cross_product_3d(up, across[0]);
  }

  /** The unit vector along which heights grow. */
  const dealii::Tensor<1, 3> &normal() const { return up; }
  /** The unit vector of coordinate @p k. */
  const dealii::Tensor<1, 3> &axis(const unsigned int k) const
  {
    return across[k];
  }
  /** The place of the coordinates zero. */
  const dealii::Point<3> &origin() const { return start; }

  /** The coordinates of the foot of a place in the plane; lengths. */
  dealii::Point<2> project(const dealii::Point<3> &place) const
  {
    const dealii::Tensor<1, 3> arm = place - start;
    return {across[0] * arm, across[1] * arm};
  }
  /** The height of a place above the plane; a length. */
  double height(const dealii::Point<3> &place) const
  {
    return up * (place - start);
  }
  /** The place at some coordinates and a height; lengths. */
  dealii::Point<3> place(const dealii::Point<2> &at,
                         const double height = 0.) const
  {
    return start + (at[0] * across[0] + at[1] * across[1] + height * up);
  }

private:
  dealii::Point<3> start;
  dealii::Tensor<1, 3> up;
  std::array<dealii::Tensor<1, 3>, 2> across;
};
} // namespace Voussoir

#endif
