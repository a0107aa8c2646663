// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_elastic_problem_h
#define voussoir_statics_energy_elastic_problem_h

#include <voussoir/algebra/joint_law.h>
#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/statics/problem/shared_problem.h>
#include <voussoir/statics/problem/solver_controls.h>
#include <voussoir/terminal/terminal.h>

namespace Voussoir
{
/**
 * The law of elastic joints that open and slide.
 *
 * Their stiffness is k_e = |e| / d_e, which the n contacts share:
 *
 *     energy = sum (k_e / n) min(y, 0)^2 / 2 + Huber(x),
 *
 * where y are the normal jumps and x the tangential one, and Huber's function
 * is k_e x^2 / 2 up to the slope s_e |e| and continues with that slope. The
 * forces are admissible for any jump.
 *
 * The second derivative of a joint that slides is zero. With a secant share it
 * has instead this share of s_e |e| / |x|, with which the quadratic of a step
 * lies above the energy if the share is one (Weiszfeld, *Tohoku Mathematical
 * Journal* 43 (1937) 355): steps are safer and converge more slowly.
 */
class ElasticJoint : public JointLaw
{
public:
  /** @param structure has the joints; it must outlive this object. */
  explicit ElasticJoint(const Structure &structure);

  void find_forces(unsigned int e,
                   const double *jumps,
                   double *forces) const override;
  bool find_second_derivatives(unsigned int e,
                               const double *jumps,
                               double *second) const override;

  /** Set the secant share, from 0 (Newton's own steps) to 1. */
  void set_secant_share(const double share) { secant_share = share; }
  /** True if a joint slides with these jumps. */
  bool slides(unsigned int e, const double *jumps) const;

private:
  const Structure &structure;
  double secant_share = 0.;
};

/** The controls of minimise_elastic(); plain data. */
struct ElasticOrder
{
  /** The method for its linear systems. */
  LinearSolver linear_solver = LinearSolver::automatic;
  /** The largest imbalance to stop at, nondimensional. */
  double tolerance = SolverControls().tolerance;
  /** The number of iterations after which to give up. */
  unsigned int n_max_iterations = SolverControls().n_max_iterations;
};

/**
 * Minimise the energy of ElasticJoint by Newton's method; collective.
 *
 * @param problem shares out and collects.
 * @param order the controls.
 * @param start n_dofs() numbers to start from; empty for zero.
 * @param terminal sees the iterations.
 * @throws SolverError if a linear system cannot be solved.
 */
Solution minimise_elastic(const SharedProblem &problem,
                          const ElasticOrder &order,
                          std::vector<double> start,
                          Terminal &terminal);
} // namespace Voussoir

#endif
