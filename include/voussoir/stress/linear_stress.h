// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_linear_stress_h
#define voussoir_stress_linear_stress_h

#include <voussoir/scene/space/face_forces.h>
#include <voussoir/scene/space/space_scene.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Voussoir
{
/** The stress inside a cell in space: symmetric and linear. */
struct LinearStress
{
  /** The centroid of the cell, where it is the mean; a length. */
  dealii::Point<3> about;
  /** The symmetric part of the mean stress; S. */
  dealii::Tensor<2, 3> mean;
  /** The derivative in x, y and z of it; S/L. */
  std::array<dealii::Tensor<2, 3>, 3> gradient = {};
  /**
   * What the forces on the faces differ from those of the stress: the root of
   * the sum of |F - F_sigma|^2 / |f| over the faces, over that of |F|^2 / |f|;
   * zero without forces.
   */
  double residual = 0.;

  /** sigma at @p x; S. */
  dealii::Tensor<2, 3> at(const dealii::Point<3> &x) const
  {
    dealii::Tensor<2, 3> sigma = mean;
    for (unsigned int k = 0; k < 3; ++k)
      sigma += (x[k] - about[k]) * gradient[k];
    return sigma;
  }
};

/**
 * The mean stress of each cell in space, from the forces on it alone:
 *
 *     |c|^-1 sum f (x) (x - x_c)
 *
 * over all forces f on it at their places x, those of interfaces and loads, and
 * the integral of b (x) (x - x_c) for body forces: the mean of any stress with
 * these tractions and div sigma = -b (paper, Section 3). Component ij is
 * sigma_ij, tension positive; S. The skew part is the residual torque over the
 * volume: rounding, if moments are balanced.
 */
std::vector<dealii::Tensor<2, 3>> cell_mean_stresses(const SpaceScene &scene,
                                                     const FaceForces &forces);

/**
 * The linear stress of each cell: of all symmetric linear fields with the mean
 * stress, symmetrised, and with the divergence that balances the forces on its
 * faces, the one whose force F and moment M through each face, interface or
 * free, come closest to those given, in the sense of the least
 *
 *     sum of (|F - F_sigma|^2 + |M - M_sigma|^2 / r^2) / |f|,
 *
 * with the area |f| and the polar radius r of each face, and of these the
 * smallest. It is exact where the stress is linear, for cells of any shape.
 * Point loads count as spread over their cells. By all threads.
 *
 * @param means cell_mean_stresses().
 */
std::vector<LinearStress>
linear_stresses(const SpaceScene &scene,
                const FaceForces &forces,
                const std::vector<dealii::Tensor<2, 3>> &means);
} // namespace Voussoir

#endif
