// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_tetrahedral_stress_h
#define voussoir_stress_tetrahedral_stress_h

#include <voussoir/stress/surface_triangles.h>

#include <cstddef>
#include <vector>

namespace Voussoir
{
/** The stress in the tetrahedra of all cells in space. */
struct TetrahedralStress
{
  /** One tetrahedron, between a centroid and a triangle of the surface. */
  struct Tetrahedron
  {
    /** The centroid first; lengths. */
    std::array<dealii::Point<3>, 4> corners;
    /** That of the triangle, among the loaded_faces() of the cell. */
    unsigned int face;
    /** The mean of sigma; S. */
    dealii::Tensor<2, 3> stress;
    /** The mean of div sigma; S/L. */
    dealii::Tensor<1, 3> divergence;
  };

  /** Those of the first cell come first. */
  std::vector<Tetrahedron> list;
  /** The first of each cell, and at last the size of the list. */
  std::vector<std::size_t> first = {0};
  /**
   * The cells without a stress of their own, whose tetrahedra, if there are
   * any, have the mean one: those that are not seen whole from their centroid,
   * and those whose faces do not close. Ascending.
   */
  std::vector<unsigned int> undetermined;
};

/** What the stress in a cell needs beside its faces; plain data. */
struct StressedCell
{
  /** A length. */
  dealii::Point<3> centroid;
  /** L^3. */
  double volume;
  /** Of cell_mean_stresses(); S. */
  dealii::Tensor<2, 3> mean;
};

/** Of all cells of a scene. */
std::vector<StressedCell>
stressed_cells(const SpaceScene &scene,
               const std::vector<dealii::Tensor<2, 3>> &means);

/**
 * The paper's reconstruction in space (eq. 15): the sub-cells of a cell are the
 * pyramids between its centroid and its faces, as in the plane the triangles
 * over its sides. The multiplier of the weak symmetry is constant in each, the
 * rows of sigma are in RT_0 on the tetrahedra into which the lines from the
 * centroids of faces cut them, with constant normal traces on the triangles,
 * and div sigma = -b; where these have no solution, as in an octahedron, that
 * in the sense of least squares, and where they have several, the least one.
 *
 * On a face that bears the force F and the moment M about its centroid the
 * trace of each triangle is F / |f| + a x (x - x_f), with the angle a by which
 * the triangles together have M.
 *
 * The symmetric part of the mean stress is taken out first, so that a uniform
 * stress comes back to rounding. By all threads.
 *
 * @param cells as many as there are,
 * @param faces loaded_faces() of each.
 */
TetrahedralStress
tetrahedral_stress(const std::vector<StressedCell> &cells,
                   const std::vector<std::vector<LoadedFace>> &faces);

/** The same of all cells of a scene with cell_mean_stresses(). */
inline TetrahedralStress
tetrahedral_stress(const SpaceScene &scene,
                   const FaceForces &forces,
                   const std::vector<dealii::Tensor<2, 3>> &means)
{
  return tetrahedral_stress(stressed_cells(scene, means),
                            loaded_faces(scene, forces));
}
} // namespace Voussoir

#endif
