// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_linear_method_h
#define voussoir_algebra_linear_method_h

#include <voussoir/algebra/structure.h>

#include <vector>

namespace Voussoir
{
/**
 * One way to solve the systems of JointSystem. There are two forms: of both
 * components of the displacement, and of one, the same for both, where the two
 * coefficients of each joint are equal.
 */
class LinearMethod
{
public:
  virtual ~LinearMethod() = default;

  /** See JointSystem::prepare(). */
  virtual bool prepare(const std::vector<Structure::Jump> &coefficients,
                       double shift) = 0;
  /** See JointSystem::solve(); the ghosts of the result are not set. */
  virtual std::vector<double> solve(const std::vector<double> &r) = 0;
  /** True if another solve() costs little after a prepare(). */
  virtual bool is_direct() const = 0;
};

/**
 * The unknowns @p u, body by body with two components each, as columns of
 * @p n_components unknowns a body.
 *
 * That is, for a system of one component all first components and then all
 * second ones, which it is solved for one after the other; for one of two
 * components @p u itself.
 */
std::vector<double> to_columns(const std::vector<double> &u,
                               unsigned int n_components);
/** The inverse of to_columns(). */
std::vector<double> from_columns(const std::vector<double> &columns,
                                 unsigned int n_components);

/**
 * Entry (i, j) of the two-by-two block of a joint with the coefficients @p a,
 * a_e^n n_e n_e^T + a_e^t t_e t_e^T; see JointSystem.
 */
inline double block_of_joint(const Structure::Joint &joint,
                             const Structure::Jump &a,
                             const unsigned int i,
                             const unsigned int j)
{
  return a.normal * joint.normal[i] * joint.normal[j] +
         a.tangential * joint.tangent[i] * joint.tangent[j];
}
} // namespace Voussoir

#endif
