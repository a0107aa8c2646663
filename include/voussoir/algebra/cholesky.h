// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_cholesky_h
#define voussoir_algebra_cholesky_h

#include <voussoir/algebra/linear_method.h>
#include <voussoir/algebra/sparse_factor.h>

namespace Voussoir
{
/** CHOLMOD on the system of a whole structure. */
class Cholesky : public LinearMethod
{
public:
  /**
   * @param structure must outlive this object, and be that of one process.
   * @param n_components of the system, one or two; see LinearMethod.
   */
  Cholesky(const Structure &structure, unsigned int n_components);

  bool prepare(const std::vector<Structure::Jump> &coefficients,
               double shift) override;
  std::vector<double> solve(const std::vector<double> &r) override;
  bool is_direct() const override;

private:
  const unsigned int n_components;
  SparseFactor factor;
};
} // namespace Voussoir

#endif
