// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_yielding_joint_h
#define voussoir_statics_energy_yielding_joint_h

#include <voussoir/algebra/joint_law.h>
#include <voussoir/statics/energy/section.h>

#include <cmath>
#include <vector>

namespace Voussoir
{
/**
 * The structure of a problem for YieldingJoint. Where blocks turn, a joint that
 * crushes has a third contact between those at its ends, whose opening is their
 * mean. It has no force; its second derivative is that which mixes the ends, of
 * a Section:
 *
 *     a x^2 + 2 b x y + c y^2
 *         = (a - b) x^2 + (c - b) y^2 + 4 b ((x + y) / 2)^2.
 */
Structure with_middle(const DiscreteProblem &problem);

/** The forces in the rows of the problem, of those in its with_middle(). */
std::vector<double> without_middle(const DiscreteProblem &problem,
                                   const std::vector<double> &forces);

/**
 * Elastic joints that yield at their limits: those that crush as a Section, if
 * blocks turn, and all others at each contact by itself.
 */
class YieldingJoint : public JointLaw
{
public:
  /**
   * @param structure of with_middle(); it must outlive this object.
   * @param problem has the limits; it must outlive this object.
   */
  YieldingJoint(const Structure &structure, const DiscreteProblem &problem)
      : structure(structure), problem(problem)
  {}
  void find_forces(unsigned int e,
                   const double *jumps,
                   double *forces) const override;
  /** Find the second derivatives; of the ends possibly negative. */
  bool find_second_derivatives(unsigned int e,
                               const double *jumps,
                               double *second) const override;

private:
  bool is_section(unsigned int e) const;
  Section section(unsigned int e) const;
  /** @{ */
  /** The bounds of the force of a contact by itself. */
  double least(unsigned int e) const;
  double most(unsigned int e) const;
  /** @} */

  const Structure &structure;
  const DiscreteProblem &problem;
};
} // namespace Voussoir

#endif
