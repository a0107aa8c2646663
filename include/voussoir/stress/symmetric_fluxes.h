// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_symmetric_fluxes_h
#define voussoir_stress_symmetric_fluxes_h

#include <voussoir/stress/surface_triangles.h>
#include <voussoir/stress/unit_fluxes.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <utility>
#include <vector>

namespace Voussoir
{
/**
 * A stress sigma on the tetrahedra between the origin and the triangles of a
 * closed surface, about as large as one: the rows of sigma are in RT_0, the
 * triangles bear given forces, sigma is symmetric in the mean of all tetrahedra
 * of a face, and div sigma is a given vector, or comes closest to it in the
 * sense of least squares where that cannot be. Where that leaves several, it is
 * the least.
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

private:
  /** The integrals of the unit fluxes through the edges of a face. */
  using FaceIntegrals =
      std::vector<std::pair<unsigned int, dealii::Tensor<1, 3>>>;
  using Rows = std::array<dealii::Vector<double>, 3>;

  void collect_integrals();
  void assemble();
  void assemble_multipliers();
  bool find_fluxes();
  double take_step();
  void add_force_of_multipliers(const dealii::Vector<double> &of,
                                Rows &to) const;
  void set_skew_parts(const Rows &of, dealii::Vector<double> &skew) const;

  const SurfaceTriangles &surface;
  const std::vector<dealii::Tensor<1, 3>> &forces;
  const dealii::Tensor<1, 3> wanted;
  /** Of each tetrahedron; the facet opposite to corner three is the triangle.
   */
  std::vector<UnitFluxes> fields;
  std::vector<FaceIntegrals> of_faces;
  dealii::LAPACKFullMatrix<double> inverse, schur;
  /** Of the conditions of symmetry. */
  dealii::Vector<double> scale;
  /** By row of sigma and edge; what the multipliers do to them. */
  Rows fluxes, of_symmetry;
  /** What the multiplier of the divergence is in each tetrahedron. */
  std::vector<dealii::Tensor<1, 3>> of_divergence;
};
} // namespace Voussoir

#endif
