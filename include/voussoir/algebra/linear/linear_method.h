// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_linear_method_h
#define voussoir_algebra_linear_linear_method_h

#include <vector>

namespace Voussoir
{
/** The coefficients of a system of JointSystem. */
struct JointStiffnesses
{
  /**
   * The blocks of the sets of rows of each joint,
   * Structure::n_all_coefficients() numbers.
   */
  std::vector<double> of_rows;
  /**
   * True if in each joint they add up, between translations, to a multiple of
   * the identity: then the components of the translations come apart.
   */
  bool are_isotropic = false;
};

/** One way to solve the systems of JointSystem; see JointBlocks. */
class LinearMethod
{
public:
  virtual ~LinearMethod() = default;
  /** Prepare solves, as JointSystem::prepare() says. */
  virtual bool prepare(const std::vector<double> &coefficients,
                       double shift) = 0;
  /**
   * Solve for @p n_columns right-hand sides @p r, one behind the other; these
   * and the solutions are of own bodies only, JointBlocks::n() numbers each.
   */
  virtual std::vector<double> solve(const std::vector<double> &r,
                                    unsigned int n_columns) = 0;
  /** True if another solve() costs little after a prepare(). */
  virtual bool is_direct() const = 0;
};

} // namespace Voussoir

#endif
