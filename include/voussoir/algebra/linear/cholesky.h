// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_cholesky_h
#define voussoir_algebra_linear_cholesky_h

#include <voussoir/algebra/linear/linear_method.h>
#include <voussoir/algebra/linear/sparse_factor.h>

namespace Voussoir
{
/** CHOLMOD on the system of a whole structure. */
class Cholesky : public LinearMethod
{
public:
  /** @param blocks of the matrix, of a structure of one process. */
  explicit Cholesky(const JointBlocks &blocks);

  bool prepare(const std::vector<double> &coefficients, double shift) override;
  std::vector<double> solve(const std::vector<double> &r,
                            unsigned int n_columns) override;
  bool is_direct() const override;

  /** SparseFactor::n_entries(). */
  double n_entries() { return factor.n_entries(); }

private:
  SparseFactor factor;
};
} // namespace Voussoir

#endif
