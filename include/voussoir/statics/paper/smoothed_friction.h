// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_paper_smoothed_friction_h
#define voussoir_statics_paper_smoothed_friction_h

#include <voussoir/statics/paper/smoothed_joint.h>
#include <voussoir/statics/problem/formulation.h>

namespace Voussoir
{
/**
 * The displacement problem with smoothed friction, solved by Ipopt with MUMPS.
 *
 * The energy of the joints is that of SmoothedJoint, with compliant contact (no
 * constraints) or hard contact (the constraints [u]_e . n_e >= 0, whose
 * multipliers are the normal forces). Either way the forces balance at the
 * minimum. They do not depend on the size of the smoothing length eps: the
 * substitution u = eps w removes it, and the problem is solved in w. The
 * smoothing chooses the state, see selection().
 */
class SmoothedFriction : public Formulation
{
public:
  std::string name() const override { return "smoothed friction"; }
  std::string meaning() const override
  {
    return "the displacement problem with |.| smoothed, solved by Ipopt.";
  }
  std::string selection() const override;
  void add_parameters(dealii::ParameterHandler &prm) override;

private:
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override;

  Contact contact = Contact::compliant;
  double smoothing_length = 1.;
  double barrier_parameter = 1e-8;
};
} // namespace Voussoir

#endif
