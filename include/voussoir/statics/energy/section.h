// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_section_h
#define voussoir_statics_energy_section_h

#include <voussoir/statics/problem/discrete_problem.h>

namespace Voussoir
{
/**
 * The section of a joint that opens and closes linearly along it, elastic and
 * ideally plastic: with the opening g(s) at s, from 0 at its start to 1 at its
 * end, the force per ds is
 *
 *     sigma(s) = min(max(k g(s), -f_c |e|), f_t |e|),
 *
 * whose resultant is that of two forces at the ends. All of (N2) in the manual
 * is reached, and nothing beyond. Nondimensional; tension is positive.
 */
class Section
{
public:
  /**
   * @param stiffness k, of the whole joint.
   * @param limits f_t |e| and f_c |e|.
   */
  Section(const double stiffness, const NormalLimits &limits)
      : stiffness_of_joint(stiffness), limits(limits)
  {}

  /** The forces at both ends. */
  struct Forces
  {
    /** @{ */
    /** The integrals of (1 - s) sigma and s sigma. */
    double at_start, at_end;
    /** @} */
  };
  /** The forces at the openings @p g_start and @p g_end of the two ends. */
  Forces forces(double g_start, double g_end) const;

  /** The derivatives of Forces by the openings, a symmetric matrix. */
  struct Stiffness
  {
    /** @{ */
    /** k times the integrals of (1 - s)^2, s^2 and s (1 - s), where elastic. */
    double at_start, at_end, mixed;
    /** @} */
  };
  /** The stiffness at the same openings; where a kink is, that of one side. */
  Stiffness stiffness(double g_start, double g_end) const;

private:
  const double stiffness_of_joint;
  const NormalLimits limits;
};
} // namespace Voussoir

#endif
