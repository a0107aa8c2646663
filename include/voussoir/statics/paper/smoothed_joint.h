// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_paper_smoothed_joint_h
#define voussoir_statics_paper_smoothed_joint_h

#include <voussoir/statics/paper/joint_energy_program.h>
#include <voussoir/statics/problem/discrete_problem.h>

namespace Voussoir
{
/** The contact between two blocks; see SmoothedJoint. */
enum class Contact
{
  /** By springs, which choose among the states of the rigid blocks. */
  compliant,
  /** Without interpenetration, which is a constraint. */
  hard
};

/**
 * The energy of one joint, and its derivatives, with smoothed friction. With
 * x = [u]_e . t_e and y = [u]_e . n_e at each of n contacts it is
 *
 *     compliant:  s_e |e| h(x) + sum (k_e / n) min(y, 0)^2 / 2,
 *                 k_e = |e| / d_e, with eps_e = s_e d_e;
 *     hard:       s_e |e| h(x), with one eps for all joints (the paper's own
 *                 form; contact is a constraint then),
 *
 * where h(x) = sqrt(x^2 + eps_e^2) - eps_e stands for |x|. The tangential force
 * s_e |e| x / sqrt(x^2 + eps_e^2) never exceeds the strength. All
 * nondimensional.
 */
class SmoothedJoint : public EnergyLaw
{
public:
  /** @param problem has the joints; it must outlive this object. */
  SmoothedJoint(const DiscreteProblem &problem, Contact contact);

  double energy(unsigned int e, const double *jumps) const override;
  void find_forces(unsigned int e,
                   const double *jumps,
                   double *forces) const override;
  bool find_second_derivatives(unsigned int e,
                               const double *jumps,
                               double *second) const override;

  /** eps_e; zero only where the joint has no strength. */
  double smoothing(unsigned int e) const;

  /** The number of contacts of a joint. */
  unsigned int n_contacts(const unsigned int e) const
  {
    return problem.n_contacts(e);
  }

  /** The displacement that stands for one smoothing length of the user. */
  double unit_smoothing() const
  {
    return contact == Contact::hard ? common_smoothing : 1.;
  }

private:
  const DiscreteProblem &problem;
  const Contact contact;
  double common_smoothing = 1.;
};
} // namespace Voussoir

#endif
