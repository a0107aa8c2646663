// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_componentwise_h
#define voussoir_algebra_linear_componentwise_h

#include <voussoir/algebra/linear/linear_method.h>
#include <voussoir/algebra/structure.h>

#include <memory>

namespace Voussoir
{

/**
 * The translations of systems in which their two components come apart: in each
 * joint the coefficients of the contacts add up to the tangential one, so that
 * a (n n^T + t t^T) is a times the identity. One matrix of half the size serves
 * both components.
 */
class Componentwise : public LinearMethod
{
public:
  /** @param one the method for the matrix of one component. */
  explicit Componentwise(std::unique_ptr<LinearMethod> one);
  /**
   * True if the translations in the system with these coefficients come apart;
   * collective.
   */
  static bool serves(const Structure &structure,
                     const std::vector<double> &coefficients);
  bool prepare(const std::vector<double> &coefficients, double shift) override;
  std::vector<double> solve(const std::vector<double> &r,
                            unsigned int n_columns) override;
  bool is_direct() const override;

private:
  std::unique_ptr<LinearMethod> one;
};

} // namespace Voussoir

#endif
