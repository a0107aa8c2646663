// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_symmetric_fluxes_h
#define voussoir_stress_symmetric_fluxes_h

#include <voussoir/stress/surface_triangles.h>
#include <voussoir/stress/unit_fluxes.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * A stress sigma on the tetrahedra between the origin and the triangles of a
 * closed surface, about as large as one: the rows of sigma are in RT_0, the
 * triangles bear given forces, sigma is symmetric in the mean of every
 * tetrahedron, and div sigma comes closest to a given vector in the sense of
 * least squares. Where that leaves several, it is the least.
 */
class SymmetricFluxes
{
public:
  /** @param surface outlives this.
   *  @param forces out through the triangles, likewise. */
  SymmetricFluxes(const SurfaceTriangles &surface,
                  const std::vector<dealii::Tensor<1, 3>> &forces,
                  const dealii::Tensor<1, 3> &divergence);

  /** @return false if a tetrahedron has no volume, or there are no digits. */
  bool find();

  /** The mean of sigma in a tetrahedron. */
  dealii::Tensor<2, 3> stress(unsigned int t) const;
  /** Its divergence there. */
  dealii::Tensor<1, 3> divergence(unsigned int t) const;
  /** The sum of |stress()|^2 times the volume. */
  double square() const;

private:
  bool find_fluxes();
  void assemble();

  const SurfaceTriangles &surface;
  const std::vector<dealii::Tensor<1, 3>> &forces;
  const dealii::Tensor<1, 3> wanted;
  /** Of each tetrahedron; the facet opposite to corner three is the triangle.
   */
  std::vector<UnitFluxes> fields;
  dealii::LAPACKFullMatrix<double> inverse, schur;
  /** Of the conditions of symmetry. */
  dealii::Vector<double> scale;
  /** Of each row, of each edge. */
  std::array<dealii::Vector<double>, 3> fluxes;
};
} // namespace Voussoir

#endif
