// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_short_sides_h
#define voussoir_stress_short_sides_h

#include <voussoir/stress/cell_stress.h>
#include <voussoir/stress/sub_triangulation.h>

#include <deal.II/base/array_view.h>

#include <vector>

namespace Voussoir
{
/**
 * A cell without its shortest sides.
 *
 * Points with few digits that should meet in one leave sides of which the
 * length is rounding, and the triangles between these and the cell's centre
 * have no digits left for a finite element. Here the ends of such a side become
 * one corner, half of the force on it goes to the side before and half to the
 * side after, and its triangle, which covers nothing but the spoke to that
 * corner, takes the stress on both sides of the spoke. With sides up to h that
 * changes forces and stresses by h, a uniform stress not at all. The forces
 * keep their resultant and, if they have couples, their torque.
 */
class ShortSides
{
public:
  /**
   * @param cut of all triangles.
   * @param shortest side that remains, over the root of the area of the cell.
   */
  ShortSides(const SubTriangulation &cut, double shortest);

  /**
   * Take a cell and the forces on it.
   *
   * @return true if it has sides to leave out, and at least three others. Else
   *   the cell is to be taken as it is, and nothing below may be called.
   */
  bool leave_out(const LoadedCell &cell);

  /** The cell that remains; its vertices are the corners. */
  const LoadedCell &rest() const { return remains; }

  /**
   * Carry the stress back to the cell that was taken.
   *
   * @param found in what remains, triangle by triangle.
   * @param sub_cells takes the result, triangle by triangle.
   */
  void fill(const std::vector<SubCellStress> &found,
            const dealii::ArrayView<SubCellStress> &sub_cells) const;

private:
  bool find_corners(const std::vector<dealii::Point<2>> &vertices);
  void share_out_forces(const LoadedCell &cell);
  void keep_torque(const LoadedCell &cell);

  const double shortest;
  const unsigned int n_per_side;
  /**
   * For each sub-cell of a triangle that is left out: which of the triangle
   * before it and of the one after it is nearest.
   */
  std::vector<unsigned int> nearest_before, nearest_after;

  /** The corner that each vertex has become. */
  std::vector<unsigned int> corner_of;
  LoadedCell remains;
};
} // namespace Voussoir

#endif
