// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_space_state_h
#define voussoir_statics_energy_space_state_h

#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/statics/problem/formulation.h>
#include <voussoir/statics/problem/solution.h>
#include <voussoir/statics/problem/solver_controls.h>
#include <voussoir/terminal/terminal.h>

namespace Voussoir
{
/**
 * Find the state of least energy of a problem in space, see FaceJoint, or its
 * collapse: by Newton's method, where that does not end soon by an
 * EnergyProgram, and where that has not all digits again by Newton's method; or
 * else any state, by find_state_or_collapse().
 *
 * @return forces if it has converged(), with Solution::selection where they are
 *   not those of least energy, or a mechanism.
 * @throws SolverError if neither is found.
 */
Solution find_space_state(const DiscreteProblem &problem,
                          const SolverControls &controls,
                          LinearSolver linear_solver,
                          Terminal &terminal);

/** The formulation that selects this state. */
class LeastEnergyInSpace : public Formulation
{
public:
  std::string name() const override { return "least energy"; }
  std::string meaning() const override
  {
    return "least energy of elastic joints, by Newton's method and an interior "
           "point.";
  }
  std::string selection() const override
  {
    return "the state of least energy of elastic joints";
  }
  /** The linear solver of Newton's method. */
  LinearSolver linear_solver = LinearSolver::automatic;

private:
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override
  {
    return find_space_state(problem, controls, linear_solver, terminal);
  }
};
} // namespace Voussoir

#endif
