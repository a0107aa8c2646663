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
  /**
   * A basis function phi in a sub-cell. The fluxes through a line between two
   * sub-cells are the same unknowns for both; those through the boundary of the
   * cell are prescribed, by the force on one half of a side.
   */
  struct Flux
  {
    /** Its unknown, or dealii::numbers::invalid_unsigned_int if prescribed. */
    unsigned int unknown;
    /**
     * If prescribed: the half of a side of the cell, 2 i for that of side i at
     * vertex i, 2 i + 1 for that at vertex i + 1.
     */
    unsigned int half;
    /**
     * If prescribed: its coefficient for a unit force that is spread evenly
     * over that half.
     */
    double per_force;
  };

  /**
   * Integrals that depend on the shape of the cell, of one sub-cell, in the
   * unit of length of the vertices that place() was given. Indices j and l are
   * those of multipliers w, k and l those of fluxes phi, q those of Gauss
   * points.
   */
  struct Integrals
  {
    /** Of the sub-cell. */
    double area;
    /** The integral of w_j, by j. */
    std::vector<double> mean;
    /** The integral of w_j w_l, by j and l. */
    dealii::Table<2, double> mass;
    /** The integral of w_j phi_k, a vector, by j and k. */
    dealii::Table<2, dealii::Tensor<1, 2>> moment;
    /** The integral of phi_k times phi_l, by k and l; only if asked for. */
    dealii::Table<2, double> flux_mass;
    /**
     * The point at which w_j is one and the others zero, by j; from the cell's
     * centre.
     */
    std::vector<dealii::Point<2>> nodes;
    /** phi_k in the middle, the image of the reference square's centre, by k.
     */
    std::vector<dealii::Tensor<1, 2>> in_the_middle;
    /** phi_k at the Gauss points, by q and k. */
    dealii::Table<2, dealii::Tensor<1, 2>> at_points;
    /** The weights of the Gauss points, by q. */
    std::vector<double> weights;
  };

  /**
   * The spaces on cells with @p n_sides sides.
   *
   * @param cut of the triangle of each side.
   * @param n_sides n, at least 3.
   * @param degree k of FE_RaviartThomas(k) and FE_DGQ(k).
   */
  CellSpaces(const SubTriangulation &cut,
             unsigned int n_sides,
             unsigned int degree);

  /** The number of sub-cells, which are numbered triangle by triangle. */
  unsigned int n_sub_cells() const { return all_integrals.size(); }

  /** The number of basis functions phi in one sub-cell. */
  unsigned int n_fluxes_per_sub_cell() const { return element.dofs_per_cell; }

  /** The number of basis functions w in one sub-cell. */
  unsigned int n_multipliers_per_sub_cell() const
  {
    return multiplier.dofs_per_cell;
  }

  /** The number of unknown fluxes of one row of sigma. */
  unsigned int n_unknown_fluxes() const { return unknown_fluxes; }

  /** Basis function phi_k of a sub-cell. */
  const Flux &flux(const unsigned int sub_cell, const unsigned int k) const
  {
    return fluxes[sub_cell * element.dofs_per_cell + k];
  }

  /**
   * The integral of w_j div phi_k over a sub-cell, the same for every shape of
   * the cell.
   */
  double divergence(const unsigned int sub_cell,
                    const unsigned int j,
                    const unsigned int k) const
  {
    return divergences(sub_cell * multiplier.dofs_per_cell + j, k);
  }

  /** The integrals of a sub-cell, in the cell that place() was given last. */
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
  void find_divergences(const dealii::DoFHandler<2> &dof_handler);
  void prescribe_fluxes(const dealii::DoFHandler<2> &dof_handler,
                        unsigned int n_sides);
  void number_fluxes(const dealii::DoFHandler<2> &dof_handler);
  void find_orientations(const dealii::DoFHandler<2> &dof_handler,
                         unsigned int n_sides);
  void map(unsigned int sub_cell,
           const std::array<dealii::Point<2>, 4> &corners);
  void integrate(Integrals &result, bool with_flux_mass) const;

  const SubTriangulation cut;
  const dealii::FE_RaviartThomas<2> element;
  const dealii::FE_DGQ<2> multiplier;
  const dealii::QGauss<2> gauss;
  /** The points of gauss, and last the middle. */
  const dealii::Quadrature<2> points;

  std::vector<Flux> fluxes;
  dealii::Table<2, double> divergences;
  /** w_j at the Gauss points. */
  dealii::Table<2, double> multipliers;
  /** phi_k on the reference square, at all points. */
  dealii::Table<2, dealii::Tensor<1, 2>> reference_values;
  /** The sign by which phi_k of a sub-cell is multiplied, 1 or -1. */
  std::vector<double> orientations;
  unsigned int unknown_fluxes = 0;
  std::vector<Integrals> all_integrals;
};
} // namespace Voussoir

#endif
