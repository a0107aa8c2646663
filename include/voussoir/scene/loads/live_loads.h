// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_live_loads_h
#define voussoir_scene_loads_live_loads_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace Voussoir
{
/** The loads that a load factor multiplies, on each cell. */
struct LiveLoads
{
  /** Their force; S L. */
  std::vector<dealii::Tensor<1, 2>> force;
  /** Their torque about x_c, positive counterclockwise; S L^2. Empty where
   * blocks do not turn. */
  std::vector<double> torque;
};
} // namespace Voussoir

#endif
