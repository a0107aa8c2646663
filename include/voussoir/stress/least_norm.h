// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_least_norm_h
#define voussoir_stress_least_norm_h

#include <voussoir/stress/cell_stress.h>
#include <voussoir/stress/local_system.h>

#include <array>

namespace Voussoir
{
/**
 * The refined reconstruction, the stress of least norm.
 *
 * On SubTriangulation::thirds(), with FE_RaviartThomas(k) and FE_DGQ(k), of all
 * weakly symmetric sigma with the given tractions those for which div sigma =
 * -b holds best, in the sense of least squares of the moments with FE_DGQ(k),
 * and of these the one of least L2 norm.
 *
 * Here the fluxes can meet all moments of div sigma that are compatible with
 * the resultant and the torque of the forces on the cell. So the divergence is
 * known beforehand,
 *
 *     div sigma = -b + a + omega R(pi/2) (x - x_c),
 *
 * the rigid acceleration that the unbalanced force and torque would give a
 * block of unit density: a = 0 where the forces balance, omega = 0 where their
 * torque does. A body force is known by its mean over the triangle of each
 * side. So where blocks turn div sigma = -b to rounding in the mean of every
 * sub-cell if b is uniform, since the trace has the couples of the sides; else
 * what b varies by in a triangle is left. What is left of
 * the symmetry inside them is 0.01 of the stress in most cells of random
 * packings and 0.1 near hinges, and falls by refinement. The least norm is then
 * the mixed form of an elastic block of unit compliance with weak symmetry
 * (Arnold, Falk and Winther, Mathematics of Computation 76 (2007), 1699): for
 * all tau with zero normal trace, w and q
 *
 *     (sigma, tau) + (v, div tau) + (tau, j(p)) = 0,
 *     (div sigma, w) = (-b + a + omega R(pi/2) (x - x_c), w),
 *     (sigma, j(q))  = 0.
 */
class LeastNorm : public CellStress
{
public:
  /**
   * The shortest side that a cell may have, over the root of its area. In the
   * triangle of a side of length h all fluxes are nearly parallel, of size 1/h
   * where what goes across is of order one, and rounding / h^2 is what their
   * scalar products leave of it: here, 1e-8.
   */
  static constexpr double shortest_side = 1e-4;

  /**
   * For cells with @p n_sides sides, at least 3, on
   * SubTriangulation::thirds(@p n_refinements), with elements of @p degree k.
   */
  LeastNorm(unsigned int n_sides, unsigned int n_refinements, unsigned degree);

private:
  bool find_fluxes() override;
  void set_known();
  void add_rigid_acceleration();
  void assemble();
  /**
   * Visit the entries (i, j) of the matrix, and (j, i) where they differ, with
   * what each sub-cell adds; no unknown is held.
   */
  template <typename Visitor>
  void for_each_entry(const Visitor &visit) const;
  dealii::DynamicSparsityPattern couplings() const;

  /** The unknown of component @p row of v, and of p: w_j in a sub-cell. */
  unsigned int velocity(unsigned int row, unsigned int s, unsigned int j) const;
  unsigned int rotation(const unsigned int s, const unsigned int j) const
  {
    return velocity(2, s, j);
  }
  /**
   * The unknowns that are held: rigid motions are in the kernel of the matrix,
   * and the right-hand side is orthogonal to them.
   */
  std::array<unsigned int, 3> held() const
  {
    return {{velocity(0, 0, 0), velocity(1, 0, 0), rotation(0, 0)}};
  }

  const unsigned int n_fluxes, n_multipliers;
  LocalSystem system;
};
} // namespace Voussoir

#endif
