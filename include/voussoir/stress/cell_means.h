// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_cell_means_h
#define voussoir_stress_cell_means_h

#include <voussoir/scene/scene.h>

#include <vector>

namespace Voussoir
{
/**
 * The mean stress of each cell, from the forces on it alone.
 *
 * It is
 *
 *     |c|^-1 (sum_e f_e (x) (x_e - x_c) + int_c b (x) (x - x_c)),
 *
 * with the force f_e on the cell and the midpoint x_e of each of its sides, the
 * first moments of tractions that vary along a side added, and the body force
 * b: the mean of any stress with these tractions and div sigma = -b.
 * Component ij is sigma_ij, tension positive; S. sigma_yx - sigma_xy is the
 * residual torque over the area.
 *
 * @return one tensor for each cell.
 */
std::vector<dealii::Tensor<2, 2>>
cell_mean_stresses(const Scene &scene, const InterfaceForces &forces);
} // namespace Voussoir

#endif
