// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_hard_contact_h
#define voussoir_statics_hard_contact_h

#include <voussoir/statics/smoothed_joint.h>
#include <voussoir/statics/solution.h>

#include <vector>

namespace Voussoir
{
/**
 * The energy of one joint with smoothed friction and hard contact at a given
 * point of the central path,
 *
 *     s_e |e| h(x) - sum mu log y,
 *
 * with x, y and h as in SmoothedJoint. The force of a contact is -mu / y. All
 * nondimensional.
 */
class HardJoint : public JointLaw
{
public:
  /**
   * @param friction for hard contact; it must outlive this object.
   * @param mu the barrier parameter, positive.
   */
  HardJoint(const SmoothedJoint &friction, const double mu)
      : friction(friction), mu(mu)
  {}

  void find_forces(unsigned int e,
                   const double *jumps,
                   double *forces) const override;
  void find_second_derivatives(unsigned int e,
                               const double *jumps,
                               double *second) const override;
  double longest_step(unsigned int e,
                      const double *jumps,
                      const double *steps) const override;

private:
  const SmoothedJoint &friction;
  const double mu;
};

/**
 * Go from where Ipopt has stopped, which is near a point of the central path,
 * to that point: Ipopt judges the product of each normal force and opening by
 * an absolute tolerance, which leaves the forces themselves few digits. Newton
 * steps double them.
 *
 * @param problem was solved.
 * @param law of its joints.
 * @param u Ipopt's displacement, n_dofs() numbers; replaced, as the forces are.
 * @param tolerance the largest imbalance that will do.
 * @param solution with Ipopt's forces. They are replaced, and it counts as
 *   converged, if the steps converge; else nothing is changed.
 */
void refine_hard_contact(const DiscreteProblem &problem,
                         const HardJoint &law,
                         std::vector<double> &u,
                         double tolerance,
                         Solution &solution);
} // namespace Voussoir

#endif
