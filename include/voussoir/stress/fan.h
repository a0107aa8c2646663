// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_fan_h
#define voussoir_stress_fan_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace Voussoir
{
/**
 * The corners of sub-cell @p i of a cell, a quadrilateral: the cell's centre,
 * its vertices i and i+1, and the midpoint of the side between them, in
 * deal.II's (lexicographic) order.
 */
std::array<dealii::Point<2>, 4> fan_sub_cell(const dealii::Point<2> &centre,
                                             const dealii::Point<2> &vertex_i,
                                             const dealii::Point<2> &vertex_j);

/**
 * The stress of one cell with n sides, on a fan of n quadrilaterals around the
 * cell's centre: each is a triangle of the centre and one side, with that side
 * cut in two.
 *
 * The rows of sigma are in FE_RaviartThomas(0), the multiplier p in FE_DGQ(0).
 * The flux of row r through a side is component r of the force on it, evenly
 * over its two halves. The mixed problem is (Marazzato and Venkataramani,
 * section 4): for all tau with zero normal trace and all q in FE_DGQ(0)
 *
 *   (div sigma, div tau) + (tau, j(p)) = -(b, div tau),
 *   (sigma, j(q))                      = 0,     j(q) = [[0, q], [-q, 0]],
 *
 * with div sigma and the body force b in the mean over each quadrilateral. So
 * sigma is symmetric in that mean, and div sigma = -b in the sense of least
 * squares: exactly over the whole cell, and in each quadrilateral if the stress
 * is uniform, or if n <= 4 and the forces leave no torque, which no symmetric
 * stress could balance. Beyond that, n spokes with two fluxes each cannot meet
 * the 3 n - 3 equations.
 *
 * The topology and the finite element spaces depend on n alone, so one object
 * serves all cells with n sides, one after the other.
 */
class Fan
{
public:
  /** What the mixed problem gives for one quadrilateral. */
  struct SubCell
  {
    /** sigma at the image of the reference centre; a stress. */
    dealii::Tensor<2, 2> stress;
    /** Mean of div sigma; a stress over a length. */
    dealii::Tensor<1, 2> divergence;
  };

  explicit Fan(unsigned int n_sides);

  /**
   * Solve the mixed problem for one cell.
   *
   * @param centre of the cell.
   * @param vertices of the cell, counterclockwise; n_sides points.
   * @param forces the force on each side, from vertex i to i+1.
   * @param body_forces the integral of b over each sub-cell.
   * @param sub_cells takes the result, one for each side.
   * @return false if the system is so close to singular that its solution would
   *   be arbitrary; sub_cells are then left alone.
   */
  bool solve(const dealii::Point<2> &centre,
             const std::vector<dealii::Point<2>> &vertices,
             const std::vector<dealii::Tensor<1, 2>> &forces,
             const std::vector<dealii::Tensor<1, 2>> &body_forces,
             const dealii::ArrayView<SubCell> &sub_cells);

private:
  /** Where a local degree of freedom of a quadrilateral stands. */
  struct LocalDof
  {
    /** Whether it belongs to the multiplier, and not to sigma. */
    bool is_multiplier;
    /** Its row of sigma. */
    unsigned int row;
    /** Its unknown, or invalid_unsigned_int if a force prescribes it. */
    unsigned int unknown;
    /** Of a basis function of sigma: its flux out of this sub-cell, 1 or -1. */
    double outward_flux;
  };

  /** The free fluxes of both rows of sigma, through one spoke per side. */
  unsigned int n_fluxes() const
  {
    return 2 * n_sides;
  }

  void make_triangulation();
  void number_unknowns();
  void place(const dealii::Point<2> &centre,
             const std::vector<dealii::Point<2>> &vertices,
             double size);
  void assemble(const std::vector<dealii::Tensor<1, 2>> &fluxes,
                const std::vector<dealii::Tensor<1, 2>> &sources);
  bool is_determined();
  double coefficient(const LocalDof &dof,
                     const dealii::Tensor<1, 2> &flux) const;

  const unsigned int n_sides;
  dealii::Triangulation<2> triangulation;
  dealii::FESystem<2> element;
  dealii::DoFHandler<2> dof_handler;
  dealii::FEValues<2> fe_values;
  unsigned int centre_point;

  /** n_sides times dofs_per_cell entries. */
  std::vector<LocalDof> local_dofs;

  dealii::LAPACKFullMatrix<double> matrix;
  dealii::LAPACKFullMatrix<double> gram;
  dealii::Vector<double> solution;
};
} // namespace Voussoir

#endif
