// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_feasible_state_h
#define voussoir_statics_conic_feasible_state_h

#include <voussoir/statics/conic/proven_factor.h>
#include <voussoir/statics/conic/row_problem.h>
#include <voussoir/statics/problem/formulation.h>

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** What find_feasible_forces() found: one of the two, or neither. */
struct FeasibleForces
{
  /** Forces strictly within their bounds, without a factor. */
  std::optional<FactorState> state;
  /** The displacement of the bodies of the rows in which loads collapse. */
  std::vector<double> collapse;
  /** The number of iterations. */
  unsigned int n_iterations = 0;
};

/**
 * Find any admissible forces that balance @p loads, see RowProblem::loads(), or
 * their collapse, by SelfDual.
 */
FeasibleForces find_feasible_forces(RowProblem &problem,
                                    const std::vector<double> &loads,
                                    unsigned int n_max_iterations,
                                    Terminal &terminal);

/**
 * Find any admissible forces of a problem, or its collapse; beside limits of
 * joints that are far beyond the loads without these, and near the limit by the
 * share of BlendedLoads.
 *
 * @return forces, if it has converged(), or a mechanism, or neither.
 */
Solution find_state_or_collapse(const DiscreteProblem &problem,
                                unsigned int n_max_iterations,
                                Terminal &terminal);

/**
 * Look for a mechanism, by the share of BlendedLoads, and without the limits of
 * joints that are far beyond the loads.
 *
 * @return none if there is none, or none was found.
 */
std::optional<Mechanism> find_collapse(const DiscreteProblem &problem,
                                       Terminal &terminal);

/**
 * The formulation of joints whose friction grows with the pressure, or that
 * bear tension, or crush, for which the others select nothing: any state, far
 * from the limits of most joints.
 */
class FeasibleState : public Formulation
{
public:
  std::string name() const override { return "interior point"; }
  std::string meaning() const override
  {
    return "any state, found by an interior-point method.";
  }
  std::string selection() const override
  {
    return "one of the states that carry the loads, far from the limits of "
           "most interfaces";
  }

private:
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override;
};
} // namespace Voussoir

#endif
