// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_stress_invariants_h
#define voussoir_stress_stress_invariants_h

#include <deal.II/base/tensor.h>

#include <cmath>

namespace Voussoir
{
/** Quantities derived from the symmetric part of a stress, in its unit. */
struct StressInvariants
{
  /** @param stress sigma_ij, of plane stress. */
  explicit StressInvariants(const dealii::Tensor<2, 2> &stress)
  {
    // By Mohr's circle: the roots of the characteristic polynomial, as
    // dealii::eigenvalues() takes them, are NaN for a nearly isotropic stress.
    const double mean = 0.5 * (stress[0][0] + stress[1][1]);
    const double radius = std::hypot(0.5 * (stress[0][0] - stress[1][1]),
                                     0.5 * (stress[0][1] + stress[1][0]));
    principal_1 = mean + radius;
    principal_2 = mean - radius;
    von_mises =
        std::sqrt(principal_1 * principal_1 - principal_1 * principal_2 +
                  principal_2 * principal_2);
  }

  double principal_1; /**< the larger principal stress */
  double principal_2; /**< the smaller one */
  double von_mises;   /**< of plane stress */
};
} // namespace Voussoir

#endif
