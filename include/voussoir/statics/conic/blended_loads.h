// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_blended_loads_h
#define voussoir_statics_conic_blended_loads_h

#include <voussoir/statics/conic/factor_bounds.h>
#include <voussoir/statics/conic/row_problem.h>

#include <vector>

namespace Voussoir
{
/**
 * Loads F blended with the loads L_0 of forces of pressure that all strengths
 * carry, whatever they are:
 *
 *     L(t) = (1 - t) L_0 + t F.
 *
 * The shares t that are carried are those up to a greatest one, which has two
 * proofs, ProvenFactor. If it is more than one F is carried, by forces between
 * the two, and if it is less F collapses in the mechanism of the bound. Unlike
 * the factor of F this decides where forces have no scale, as those of dry
 * joints: there a factor is zero or infinite however near the limit is.
 */
class BlendedLoads
{
public:
  /** @param problem must outlive this object. */
  explicit BlendedLoads(const DiscreteProblem &problem);

  /** The problem by rows. */
  RowProblem &by_rows() { return of_rows; }
  /** With t for alpha. */
  const SelfDual::Program &program() const { return of_share; }
  /** Forces that balance F, of each row of each joint, from forces @p x of
   * rows that are in balance at a share of one or more. */
  std::vector<double> forces_of_all(const std::vector<double> &x,
                                    double share) const;
  /**
   * Whether the work of F in a mechanism that bounds the share, less what is
   * dissipated, is more than rounding, and than forces of their size do where
   * joints close.
   */
  bool collapse(const FactorMotion &motion, double bound) const;

private:
  const DiscreteProblem &problem;
  RowProblem of_rows;
  /** Of each row of each joint. */
  std::vector<double> pressing_forces;
  SelfDual::Program of_share;
};
} // namespace Voussoir

#endif
