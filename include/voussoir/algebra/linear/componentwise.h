// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_componentwise_h
#define voussoir_algebra_linear_componentwise_h

#include <voussoir/algebra/linear/linear_method.h>

#include <memory>

namespace Voussoir
{

/**
 * The translations of systems in which their components come apart: each joint
 * is as stiff in one direction as in the other, so that a (n n^T + t t^T) is a
 * times the identity. One matrix of the size of one component serves them all.
 */
class Componentwise : public LinearMethod
{
public:
  /**
   * @param one the method for the matrix of one component.
   * @param n_components of the translations.
   */
  Componentwise(std::unique_ptr<LinearMethod> one, unsigned int n_components);
  bool prepare(const std::vector<double> &coefficients, double shift) override;
  std::vector<double> solve(const std::vector<double> &r,
                            unsigned int n_columns) override;
  bool is_direct() const override;

private:
  std::unique_ptr<LinearMethod> one;
  unsigned int n_components;
};

} // namespace Voussoir

#endif
