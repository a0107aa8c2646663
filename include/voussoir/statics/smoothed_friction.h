// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_smoothed_friction_h
#define voussoir_statics_smoothed_friction_h

#include <voussoir/statics/formulation.h>

namespace Voussoir
{
/**
 * The displacement problem with smoothed friction, solved by Ipopt with MUMPS.
 *
 * With x = [u]_e . t_e and y = [u]_e . n_e, |x| is replaced by
 * h(x) = sqrt(x^2 + eps_e^2) - eps_e, and contact is one of
 *
 *   compliant:  minimise sum_e s_e |e| h(x_e) + k_e min(y_e, 0)^2 / 2
 *                        - sum_c F_c . u_c,        k_e = |e| / d_e,
 *               with eps_e proportional to s_e d_e; no constraints;
 *   hard:       minimise sum_e s_e |e| h(x_e) - sum_c F_c . u_c
 *               subject to y_e >= 0, with the same eps for all joints
 *               (the paper's own form).
 *
 * The tangential force is f_e^t = s_e |e| x / sqrt(x^2 + eps_e^2), so never
 * above the strength; the normal force is f_e^n = k_e min(y, 0) or minus the
 * multiplier of y_e >= 0. Either way the forces balance at the minimum. They do
 * not depend on the size of eps: the substitution u = eps w removes it, and the
 * problem is solved in w. What the smoothing chooses is the state, see
 * selection().
 */
class SmoothedFriction : public Formulation
{
public:
  enum class Contact
  {
    compliant,
    hard
  };

  std::string name() const override;
  std::string meaning() const override;
  std::string selection() const override;
  void add_parameters(dealii::ParameterHandler &prm) override;

private:
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override;

  Contact contact = Contact::compliant;
  double smoothing_length = 1.;
};
} // namespace Voussoir

#endif
