// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_paper_analytic_centre_h
#define voussoir_statics_paper_analytic_centre_h

#include <voussoir/statics/energy/barrier_joint.h>
#include <voussoir/statics/problem/formulation.h>

#include <string>

namespace Voussoir
{
/**
 * The analytic centre of the admissible and balanced states.
 *
 * It is the state that maximises
 *
 *     sum_e w_e (log p_e + log(s_e |e| - q_e) + log(s_e |e| + q_e)).
 *
 * Its dual is one problem without constraints, that of BarrierJoint: the forces
 * of a path-following method do not change along the path, since the energy is
 * homogeneous, so that no path is needed. Newton's method solves it.
 *
 * If no state has every p_e > 0 and every |q_e| < s_e |e|, the displacement
 * grows without end, and shows as it does which joints are never pressed and
 * which always slide; the centre is that of the others, in the relative
 * interior of the admissible states.
 */
class AnalyticCentre : public Formulation
{
public:
  std::string name() const override { return "analytic centre"; }
  std::string meaning() const override
  {
    return "the state farthest from all limits of admissibility, by Newton's "
           "method.";
  }
  std::string selection() const override;
  void add_parameters(dealii::ParameterHandler &prm) override;

private:
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override;

  Solution find_centre(const DiscreteProblem &problem,
                       const SolverControls &controls,
                       Terminal &terminal) const;

  BarrierWeights weights = BarrierWeights::edge_area;
};
} // namespace Voussoir

#endif
