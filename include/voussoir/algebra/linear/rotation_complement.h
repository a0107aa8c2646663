// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_rotation_complement_h
#define voussoir_algebra_linear_rotation_complement_h

#include <voussoir/algebra/linear/linear_method.h>
#include <voussoir/algebra/structure.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <memory>

namespace Voussoir
{

/**
 * The systems of bodies that turn in the plane, of which the translations alone
 * come apart; see Componentwise. With the blocks of translations u and
 * rotations theta
 *
 *     ( L  C ) (u    )   (r    )
 *     ( C' D ) (theta) = (m),
 *
 * conjugate gradients solve (D - C' L^{-1} C) theta = m - C' L^{-1} r. Their
 * number does not grow with that of the bodies, but with their irregularity.
 */
class RotationComplement : public LinearMethod
{
public:
  /**
   * @param structure has the joints; it must outlive this object.
   * @param translations the method for the block L.
   */
  RotationComplement(const Structure &structure,
                     std::unique_ptr<LinearMethod> translations);
  bool prepare(const std::vector<double> &coefficients, double shift) override;
  /** @return nothing if too many conjugate gradients would be needed. */
  std::vector<double> solve(const std::vector<double> &r,
                            unsigned int n_columns) override;
  bool is_direct() const override;

private:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;
  /** The blocks of a joint that belong to rotations. */
  struct Coupling
  {
    /** @{ */
    /** The force between the bodies for a unit rotation of c-, and of c+. */
    std::array<double, 2> minus, plus;
    /** @} */
    /** @{ */
    /** The couples on c-, on c+, and on c+ from c-. */
    double of_minus, of_plus, mixed;
    /** @} */
  };
  class Operator;

  /** L^{-1} of the translations in @p v (n_dofs() numbers), with ghosts. */
  void solve_translations(std::vector<double> &v);
  /** Add @p factor C' u to the couples in @p m, from u in @p v. */
  void
  add_couples(const std::vector<double> &v, double factor, Vector &m) const;

  const Structure &structure;
  const std::unique_ptr<LinearMethod> translations;
  std::vector<Coupling> couplings;
  double shift = 0.;
  /** The norm of the largest right-hand side since prepare(). */
  double largest_right = 0.;
  dealii::DiagonalMatrix<Vector> diagonal;
};

} // namespace Voussoir

#endif
