// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_joint_law_h
#define voussoir_algebra_joint_law_h

#include <voussoir/algebra/structure.h>

#include <limits>
#include <numeric>

namespace Voussoir
{
/**
 * True if a joint in the plane is as stiff in one direction as in the other, to
 * the last digit, with the stiffnesses @p k of its contacts, @p n_contacts of
 * them, and of sliding behind them.
 */
inline bool is_isotropic(const double *k, const unsigned int n_contacts)
{
  return std::accumulate(k, k + n_contacts, 0.) == k[n_contacts];
}

/**
 * The convex energy of each joint as a function of its jumps, with mixed second
 * derivatives within a set of rows only. Minimising
 *
 *     sum_e energy_e([u]_e) - sum_c F_c . u_c
 *
 * makes the first derivatives forces that balance the load; which of the
 * admissible states they are is the choice of the law. All nondimensional.
 * Joints are numbered as in Structure::joints(); jumps and forces of a joint
 * are Structure::n_rows() numbers, second derivatives the blocks of its sets of
 * rows, one behind the other.
 */
class JointLaw
{
public:
  virtual ~JointLaw() = default;
  /** Find the forces: the first derivatives of the energy. */
  virtual void
  find_forces(unsigned int e, const double *jumps, double *forces) const = 0;
  /**
   * Find the second derivatives; those of a joint are positive semidefinite
   * together, as a form in the motions of its bodies.
   *
   * @return true if the joint is as stiff in one direction as in the other, to
   *   the last digit: the blocks of its rows, between translations, add up to a
   *   multiple of the identity.
   */
  virtual bool find_second_derivatives(unsigned int e,
                                       const double *jumps,
                                       double *second) const = 0;
  /**
   * The multiple of @p steps that may be added to @p jumps before the energy of
   * joint @p e is infinite; infinity if it never is.
   */
  virtual double longest_step(unsigned int /*e*/,
                              const double * /*jumps*/,
                              const double * /*steps*/) const
  {
    return std::numeric_limits<double>::infinity();
  }
};

} // namespace Voussoir

#endif
