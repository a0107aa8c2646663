// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_cell_spaces_h
#define voussoir_stress_cell_spaces_h

#include <voussoir/stress/sub_triangulation.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/table.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_raviart_thomas.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * The finite element spaces on the sub-triangulation of a cell with n sides,
 * and the integrals of their basis functions. Both rows of sigma are in the
 * same FE_RaviartThomas(k), with basis functions phi; the multipliers in
 * FE_DGQ(k), with basis functions w.
 *
 * The topology and the spaces depend on n alone, so one object serves all cells
 * with n sides, one after the other.
 */
class CellSpaces
{
public:
  /** A basis function phi in a sub-cell. */
  struct Flux
  {
    /** Its unknown, or dealii::numbers::invalid_unsigned_int if prescribed. */
    unsigned int unknown;
    /** If prescribed: the side of the cell, and the coefficient for a unit
     * force that is spread evenly over that side. */
    unsigned int side;
    double per_force;
  };

  /** What depends on the shape of the cell, of one sub-cell. */
  struct Integrals
  {
    double area;
    /** int w_j */
    std::vector<double> mean;
    /** int w_j w_l */
    dealii::Table<2, double> mass;
    /** int w_j phi_k, component by component. */
    dealii::Table<2, dealii::Tensor<1, 2>> moment;
    /** int phi_k . phi_l; only if asked for. */
    dealii::Table<2, double> flux_mass;
    /** Where w_j is one and the others zero. */
    std::vector<dealii::Point<2>> nodes;
    /** phi_k in the middle, the image of the reference square's centre. */
    std::vector<dealii::Tensor<1, 2>> in_the_middle;
    /** phi_k at the Gauss points, and the weights of these. */
    dealii::Table<2, dealii::Tensor<1, 2>> at_points;
    std::vector<double> weights;
  };

  CellSpaces(const SubTriangulation &cut,
             unsigned int n_sides,
             unsigned int degree);

  /** The sub-cells, triangle by triangle. */
  unsigned int n_sub_cells() const;
  /** The basis functions phi and w of one sub-cell. */
  unsigned int n_fluxes_per_sub_cell() const;
  unsigned int n_multipliers_per_sub_cell() const;
  /** The unknown fluxes of one row of sigma. */
  unsigned int n_unknown_fluxes() const;

  const Flux &flux(const unsigned int sub_cell, const unsigned int k) const
  {
    return fluxes[sub_cell * element.dofs_per_cell + k];
  }

  /** int w_j div phi_k over a sub-cell, whatever the shape of the cell. */
  double divergence(const unsigned int sub_cell,
                    const unsigned int j,
                    const unsigned int k) const
  {
    return divergences(sub_cell * multiplier.dofs_per_cell + j, k);
  }

  const Integrals &integrals(const unsigned int sub_cell) const
  {
    return all_integrals[sub_cell];
  }

  /**
   * Take the shape of a cell: its vertices from its centre, counterclockwise.
   * With @p with_flux_mass also the integrals of phi_k . phi_l are computed.
   */
  void place(const std::vector<dealii::Point<2>> &vertices,
             bool with_flux_mass);

private:
  void make_triangulation(dealii::Triangulation<2> &triangulation,
                          unsigned int n_sides) const;
  void number_fluxes(const dealii::DoFHandler<2> &dof_handler,
                     unsigned int n_sides);
  void find_orientations(const dealii::DoFHandler<2> &dof_handler,
                         unsigned int n_sides);
  void map(unsigned int sub_cell,
           const std::array<dealii::Point<2>, 4> &corners);
  void integrate(Integrals &result, bool with_flux_mass) const;

  const SubTriangulation cut;
  const dealii::FE_RaviartThomas<2> element;
  const dealii::FE_DGQ<2> multiplier;
  const dealii::QGauss<2> gauss;
  /** Those of gauss, and last the middle. */
  const dealii::Quadrature<2> points;

  std::vector<Flux> fluxes;
  dealii::Table<2, double> divergences;
  /** w_j at the Gauss points. */
  dealii::Table<2, double> multipliers;
  /** phi_k on the reference square, at all points. */
  dealii::Table<2, dealii::Tensor<1, 2>> reference_values;
  /** By which phi_k of a sub-cell is multiplied, 1 or -1. */
  std::vector<double> orientations;
  unsigned int unknown_fluxes = 0;
  std::vector<Integrals> all_integrals;
};
} // namespace Voussoir

#endif
