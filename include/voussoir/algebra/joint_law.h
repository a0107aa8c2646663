// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_joint_law_h
#define voussoir_algebra_joint_law_h

#include <voussoir/algebra/structure.h>

#include <limits>

namespace Voussoir
{

/**
 * The convex energy of each joint as a function of its jumps, without mixed
 * second derivatives. Minimising
 *
 *     sum_e energy_e([u]_e) - sum_c F_c . u_c
 *
 * makes the first derivatives forces that balance the load; which of the
 * admissible states they are is the choice of the law. All nondimensional.
 * Joints are numbered as in Structure::joints(), and jumps, forces and second
 * derivatives of a joint are Structure::n_rows() numbers.
 */
class JointLaw
{
public:
  virtual ~JointLaw() = default;
  /** Find the forces: the first derivatives of the energy. */
  virtual void
  find_forces(unsigned int e, const double *jumps, double *forces) const = 0;
  /** Find the second derivatives; not negative. */
  virtual void find_second_derivatives(unsigned int e,
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
