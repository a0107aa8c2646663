// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_algebra_joint_law_h
#define voussoir_algebra_joint_law_h

#include <voussoir/algebra/structure.h>

#include <limits>

namespace Voussoir
{
/**
 * The convex energy of each joint as a function of its jump, without mixed
 * second derivative. Minimising
 *
 *     sum_e energy_e([u]_e) - sum_c F_c . u_c
 *
 * makes the first derivatives forces that balance the load; which of the
 * admissible states they are is the choice of the law. All nondimensional.
 * Joints are numbered as in Structure::joints().
 */
class JointLaw
{
public:
  /** Of displacements, forces or second derivatives; see Structure::Jump. */
  using Jump = Structure::Jump;

  virtual ~JointLaw() = default;

  /** The forces f_e^n and f_e^t: the first derivatives of the energy. */
  virtual Jump force(unsigned int e, const Jump &jump) const = 0;
  /** The second derivatives; not negative. */
  virtual Jump second_derivative(unsigned int e, const Jump &jump) const = 0;
  /**
   * The multiple of @p step that may be added to @p jump before the energy of
   * joint @p e is infinite; infinity if it never is.
   */
  virtual double longest_step(unsigned int /*e*/,
                              const Jump & /*jump*/,
                              const Jump & /*step*/) const
  {
    return std::numeric_limits<double>::infinity();
  }
};
} // namespace Voussoir

#endif
