// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_slender_tetrahedra_h
#define voussoir_stress_slender_tetrahedra_h

#include <voussoir/stress/surface_triangles.h>

#include <vector>

namespace Voussoir
{
/**
 * A cell's surface of triangles without those whose tetrahedra with the origin
 * are slender.
 *
 * Step by step, that first which changes the least volume: the ends of an edge
 * become one point in its middle, whereby its two triangles vanish; or two
 * triangles that share an edge are cut along the other diagonal of their
 * corners, where one of them is flat. Each step changes little of the volume,
 * which does not depend on the aspect of the cell: a slab has no slender
 * tetrahedra.
 *
 * The force on a triangle that vanishes goes in halves to those beyond its two
 * other edges, and that on two triangles that are cut otherwise to the new ones
 * by their volumes: the resultant stays, and moments change by a force times
 * the length that was left out.
 */
class SlenderTetrahedra
{
public:
  /** A part of what came in place of a triangle. */
  struct Heir
  {
    /** Its number in surface. */
    unsigned int triangle;
    /** All of one triangle sum to one. */
    double share;
  };

  /**
   * @param surface closed, around the origin.
   * @param forces on the triangles, in any unit.
   */
  SlenderTetrahedra(const SurfaceTriangles &surface,
                    const std::vector<dealii::Tensor<1, 3>> &forces);

  /** What remains. */
  SurfaceTriangles surface;
  /** On its triangles. */
  std::vector<dealii::Tensor<1, 3>> forces;
  /** For each triangle that there was, what came in its place. */
  std::vector<std::vector<Heir>> heirs;
};
} // namespace Voussoir

#endif
