// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_cell_stress_h
#define voussoir_stress_cell_stress_h

#include <voussoir/stress/cell_spaces.h>

#include <deal.II/base/array_view.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Voussoir
{
/** The stress in one sub-cell, as far as it is known. */
struct SubCellStress
{
  /** sigma at the image of the reference square's centre; S. */
  dealii::Tensor<2, 2> stress;
  /** Mean of div sigma; S/L. */
  dealii::Tensor<1, 2> divergence;
  /** Root of the mean square of (sigma_xy - sigma_yx) / 2; S. */
  double skew = 0.;
};

/** A cell with n sides, cut free of all others, and the forces on it. */
struct LoadedCell
{
  /** x_c; a length. */
  dealii::Point<2> centre;
  /** Counterclockwise; n points, lengths. */
  std::vector<dealii::Point<2>> vertices;
  /** Of n forces on the cell that on side i, from vertex i to i+1; S L. */
  std::vector<dealii::Tensor<1, 2>> forces;
  /**
   * n integrals of the body force, over the triangle of the centre and each
   * side; S L.
   */
  std::vector<dealii::Tensor<1, 2>> body_forces;
  /**
   * n parts of the forces, D, shifted from the first half of each side to the
   * second, or none; S L. See CellForces::shift_on_side.
   */
  std::vector<dealii::Tensor<1, 2>> shifts = {};

  /** Side i, from vertex i to vertex i+1; a length. */
  dealii::Tensor<1, 2> side(const unsigned int i) const
  {
    return vertices[(i + 1) % vertices.size()] - vertices[i];
  }
  /** The sum of f (x) (x - x_c) over all forces f on it; S L^2. */
  dealii::Tensor<2, 2> moments() const;
};

/**
 * The stress of one cell with n sides from the forces on its sides.
 *
 * The rows of sigma are in FE_RaviartThomas. The trace sigma n is constant on
 * each half of a side: the force F there over its length where it has no
 * couple, F/2 -+ D on the halves where it has one. So sigma has the resultant
 * and the couple through each side. Where the resultant passes outside the
 * middle half of a side, at more than |e|/4 from its midpoint, the other half
 * has tension, which the interface has not. And sigma is symmetric in the weak
 * sense,
 *
 *     (sigma, j(q)) = 0 for all q in FE_DGQ,  j(q) = [[0, q], [-q, 0]].
 *
 * A derived class says which of these fields is meant. One object serves all
 * cells with n sides, one after the other.
 *
 * The symmetric part of the mean stress is taken out first; it solves the
 * problem of its own tractions, and what remains is found with the precision of
 * the remainder. So a uniform stress comes back to rounding, whatever the shape
 * of the cell.
 *
 * If the centre and a side make a slender triangle, the integrals there have
 * few digits. Such a cell is solved a second time, turned by an angle, in which
 * all of them are rounded differently, and the difference of the two solutions
 * is the effect of rounding.
 */
class CellStress
{
public:
  virtual ~CellStress() = default;

  /**
   * Find the stress in one cell.
   *
   * @param sub_cells takes the result, n_sub_cells() elements, triangle by
   *   triangle.
   * @return false if the solution would be arbitrary, or has lost its digits:
   *   if its mean is not that which the forces demand, or if in the cell turned
   *   it is another. sub_cells are then left alone.
   */
  bool solve(const LoadedCell &cell,
             const dealii::ArrayView<SubCellStress> &sub_cells);

  /** The number of sub-cells, over all n triangles. */
  unsigned int n_sub_cells() const { return spaces.n_sub_cells(); }

protected:
  /** Of CellSpaces; @p with_flux_mass says whether find_fluxes() needs it. */
  CellStress(const SubTriangulation &cut,
             unsigned int n_sides,
             unsigned int degree,
             bool with_flux_mass);

  /**
   * Find the unknown fluxes in the cell that spaces has the shape of, under
   * forces and body_force(): row r of sigma has coefficient(r, ...).
   *
   * @return false if there is no unique answer.
   */
  virtual bool find_fluxes() = 0;

  /** The coefficient of basis function @p k of a sub-cell in row @p row. */
  double coefficient(const unsigned int row,
                     const unsigned int sub_cell,
                     const unsigned int k) const
  {
    const CellSpaces::Flux &flux = spaces.flux(sub_cell, k);
    return flux.unknown == dealii::numbers::invalid_unsigned_int
               ? flux.per_force * forces[flux.half][row]
               : unknowns[row * spaces.n_unknown_fluxes() + flux.unknown];
  }

  /** The body force in a sub-cell, in the mean over its triangle. */
  const dealii::Tensor<1, 2> &body_force(const unsigned int sub_cell) const
  {
    return sources[sub_cell / n_per_side];
  }

  /** The spaces, in the shape of the present cell, scaled to unit area. */
  CellSpaces spaces;
  /**
   * The n_unknown_fluxes() of row 0, then those of row 1, and what else a
   * derived class solves for.
   */
  dealii::Vector<double> unknowns;
  /**
   * The rest of the force on each half of a side, over the size of the cell;
   * see CellSpaces::Flux::half.
   */
  std::vector<dealii::Tensor<1, 2>> forces;

private:
  bool solve_once(const LoadedCell &cell, std::vector<SubCellStress> &result);
  SubCellStress stress_in(unsigned int sub_cell) const;
  bool scale(const LoadedCell &cell);
  void take_out_mean(const LoadedCell &cell);
  double largest_stress() const;
  bool mean_is_right() const;
  bool is_same_turned(const LoadedCell &cell);

  const bool with_flux_mass;
  const unsigned int n_per_side;
  /** In a cell of unit area. */
  std::vector<dealii::Point<2>> corners;
  std::vector<dealii::Tensor<1, 2>> sources;
  dealii::Tensor<2, 2> mean;
  double size = 0.;
  /** The least area of a triangle over the square of its longest side. */
  double slenderness = 0.;
  std::vector<SubCellStress> found, found_turned;
};
} // namespace Voussoir

#endif
