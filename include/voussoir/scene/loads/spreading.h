// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_spreading_h
#define voussoir_scene_loads_spreading_h

#include <voussoir/packing/packing.h>
#include <voussoir/scene/loads/cell_forces.h>

#include <functional>
#include <vector>

namespace Voussoir
{
/**
 * How soil spreads a vertical force on its surface: along rays down from there,
 * within an angle on both sides. Between the angles a and b from the vertical
 * goes the share (F(b) - F(a)) / 2 F(limit).
 */
struct Spreading
{
  /** The function F. */
  enum class Law
  {
    /** F = 0: none is spread. */
    none,
    /** F = tan(a): a constant stress on level ground. */
    uniform,
    /**
     * F = a + sin(2 a) / 2: the stress 2 P z^3 / (pi r^4) of Boussinesq and
     * Flamant in the elastic half plane under a line load P.
     */
    elastic
  };

  Law law = Law::none;     /**< this */
  double limit = 0.;       /**< the largest angle, radians */
  std::vector<bool> edges; /**< of the boundary, on which the soil lies */
  /** The height of the surface at x; lengths. */
  using Height = std::function<double(double)>;
  Height top; /**< this */

  /**
   * The forces on the blocks below.
   *
   * @param x of the place on the surface where the force stands.
   * @param force that acts downwards; S L.
   * @return one for each edge that some of it comes to. What goes beside the
   *   blocks is not among them, and rays end at the first block.
   */
  std::vector<CellForce>
  forces(const Packing<2> &packing, double x, double force) const;
};
} // namespace Voussoir

#endif
