// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_near_componentwise_h
#define voussoir_algebra_linear_near_componentwise_h

#include <voussoir/algebra/linear/linear_method.h>
#include <voussoir/algebra/structure.h>

#include <deal.II/lac/vector.h>

#include <memory>

namespace Voussoir
{
/**
 * Translations of which the two components come apart but for a little: in each
 * joint the tangential coefficient is not far from the sum of those of the
 * contacts. Where it is this sum Componentwise solves, and that is the
 * preconditioner of conjugate gradients here. If the tangential ones are
 * smaller by factors of up to r, each iteration reduces the error by (sqrt(r) -
 * 1) / (sqrt(r) + 1) or more, whatever the size of the packing; if some are
 * larger as well, by (r - 1) / (r + 1). For a process that is alone.
 */
class NearComponentwise : public LinearMethod
{
public:
  /**
   * @param structure has the joints; it must outlive this object.
   * @param componentwise the method for the preconditioner.
   * @param residual to stop at, relative to the right-hand side.
   */
  NearComponentwise(const Structure &structure,
                    std::unique_ptr<LinearMethod> componentwise,
                    double residual);
  /** True if the coefficients are not far from those of Componentwise. */
  static bool serves(const Structure &structure,
                     const std::vector<double> &coefficients);
  /** It factorises only if coefficients of contacts have changed. */
  bool prepare(const std::vector<double> &coefficients, double shift) override;
  /** @return nothing if too many conjugate gradients would be needed. */
  std::vector<double> solve(const std::vector<double> &r,
                            unsigned int n_columns) override;
  bool is_direct() const override { return false; }

private:
  using Vector = dealii::Vector<double>;
  /** The matrix, and its preconditioner. */
  class Operator;
  class Preconditioner;

  const Structure &structure;
  const std::unique_ptr<LinearMethod> componentwise;
  const double residual;
  /** Of the matrix, and of the preconditioner. */
  std::vector<double> coefficients, factorised;
  double shift = 0.;
};

} // namespace Voussoir

#endif
