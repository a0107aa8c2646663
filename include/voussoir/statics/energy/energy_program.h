// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_energy_program_h
#define voussoir_statics_energy_energy_program_h

#include <voussoir/statics/problem/mechanism.h>
#include <voussoir/statics/problem/solution.h>
#include <voussoir/statics/problem/solver_controls.h>
#include <voussoir/terminal/terminal.h>

#include <optional>
#include <vector>

namespace Voussoir
{
/** What the forces of one joint cost; nondimensional. See EnergyProgram. */
struct JointCost
{
  /** c^n of all contacts together, each of which has it over its share; not
   * negative. */
  double normal_compliance = 0.;
  /** c^t, not negative. */
  double tangential_compliance = 0.;
  /** eps, not negative; the same sign in all joints with friction. */
  double smoothing = 0.;
};

/** What the forces of each joint cost in the energy of ElasticJoint. */
std::vector<JointCost> elastic_costs(const DiscreteProblem &problem);

/**
 * The admissible and balanced forces with the least
 *
 *     sum_e (c_e^n p_e^2 / 2 + c_e^t q_e^2 / 2 - eps_e (b_e^2 - q_e^2)^(1/2)),
 *
 * with b_e = s_e |e| and, of contacts that share a joint, p_e^2 of each over
 * its share: with c^n = c^t = d_e/|e| and eps = 0 least energy, with that c^n,
 * c^t = 0 and eps = s_e d_e smoothed friction with compliant contact. Of a
 * program of SelfDual that is a quadratic cost, and with smoothing one that is
 * linear in what an arc leaves of the strength, ForceRows.
 *
 * It takes 10 to 30 linear systems, of the same kind as Newton's, however close
 * the load is to its limit, or proves that it is beyond it.
 */
struct EnergyProgram
{
  /** The displacement in the minimum: n_dofs() numbers. */
  std::vector<double> u;
  /** Of each row of each joint, as in Structure. */
  std::vector<double> forces;
  /** SelfDual::merit(), about the square of the error of the forces. */
  double error;
  /** The proof that there is no minimum. */
  std::optional<Mechanism> mechanism;
  /** The number of iterations. */
  unsigned int n_iterations = 0;
};

/**
 * Solve the program.
 *
 * @param problem with Tresca's friction, and joints that bear tension, or crush
 *   if blocks do not turn.
 * @param costs of each of its joints.
 * @param error to stop at; less can be had than is asked for.
 * @param n_max_iterations that it may take.
 * @param terminal sees the iterations.
 */
EnergyProgram solve_energy_program(const DiscreteProblem &problem,
                                   const std::vector<JointCost> &costs,
                                   double error,
                                   unsigned int n_max_iterations,
                                   Terminal &terminal);

/**
 * Give a @p solution that has not converged a second chance, by way of the
 * energy program with the @p costs. Iterations add up.
 *
 * @return its forces and their displacement, or a mechanism, or if there is
 *   neither what there was before.
 */
Solution second_attempt(const DiscreteProblem &problem,
                        const std::vector<JointCost> &costs,
                        const SolverControls &controls,
                        Solution solution,
                        Terminal &terminal);
} // namespace Voussoir

#endif
