// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_fan_h
#define voussoir_stress_fan_h

#include <voussoir/stress/cell_stress.h>
#include <voussoir/stress/local_system.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Voussoir
{
/**
 * The paper's reconstruction, the local Raviart-Thomas problem of Marazzato and
 * Venkataramani (paper, eq. 15 and Proposition 8).
 *
 * On a fan of n quadrilaterals around the cell's centre, with
 * FE_RaviartThomas(0) and FE_DGQ(0), for all tau with zero normal trace and all
 * q
 *
 *     (div sigma, div tau) + (tau, j(p)) = -(b, div tau),
 *     (sigma, j(q))                      = 0,
 *
 * with div sigma and the body force b in the mean over each quadrilateral. So
 * sigma is symmetric in that mean, and div sigma = -b in the sense of least
 * squares: exactly over the whole cell, and in each quadrilateral if the stress
 * is uniform, or if n <= 4 and the forces leave no torque, which no symmetric
 * stress could balance. Beyond that, or where the sides have couples, n spokes
 * with two fluxes each cannot meet the 3 n - 3 equations. Where blocks turn and
 * joints are close to a hinge, what is left of div sigma + b, times the size of
 * the cell, is as large as the stress, and sigma_xy - sigma_yx half as large
 * inside a quadrilateral; in most cells of random packings, 0.1 and 0.02 of it.
 */
class Fan : public CellStress
{
public:
  /**
   * The shortest side that a cell may have, over the root of its area h.
   * Rounding / h is what it costs: here, 1e-7.
   */
  static constexpr double shortest_side = 1e-9;

  /** For cells with @p n_sides sides, at least 3. */
  explicit Fan(unsigned int n_sides);

private:
  bool find_fluxes() override;
  bool is_determined();
  /** Visit the entries (i, j) of the matrix with what each sub-cell adds. */
  template <typename Visitor>
  void for_each_entry(const Visitor &visit) const;
  dealii::DynamicSparsityPattern couplings() const;

  const unsigned int n_sides;
  LocalSystem system;
  /** The lower half of B B^T; see is_determined(). */
  dealii::FullMatrix<double> gram;
  /** The last sub-cell, and its integral of tau : j(1), for each unknown. */
  std::vector<std::pair<unsigned int, double>> first_of_flux;
};
} // namespace Voussoir

#endif
