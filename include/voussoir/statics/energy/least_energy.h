// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_energy_least_energy_h
#define voussoir_statics_energy_least_energy_h

#include <voussoir/algebra/linear/joint_system.h>
#include <voussoir/statics/problem/formulation.h>

namespace Voussoir
{
/**
 * Of all admissible and balanced states, that of least energy.
 *
 * It minimises
 *
 *     sum_e (d_e / |e|) ((f_e^n)^2 + (f_e^t)^2) / 2.
 *
 * It is unique and keeps every symmetry of the scene. On Voronoi packings, in
 * which the line between two centres is normal to their joint, it returns every
 * uniform stress that is admissible; on others not exactly. Its dual is a
 * convex, piecewise quadratic problem in the displacements without constraints,
 * that of ElasticJoint, which Newton's method solves. Joints that bear tension
 * or crush yield instead, see minimise_yielding().
 */
class LeastEnergy : public Formulation
{
public:
  std::string name() const override { return "least energy"; }
  std::string meaning() const override
  {
    return "the least energy of elastic joints, solved by Newton's method; the "
           "fastest, from one cell to a million.";
  }
  std::string selection() const override
  {
    return "least energy: the least sum of d_e/|e| times the square of the "
           "force on the interface";
  }
  void add_parameters(dealii::ParameterHandler &prm) override;

private:
  double displacement_unit(const DiscreteProblem &problem) const override
  {
    return problem.stress_scale() * problem.length_scale() / modulus;
  }
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override;

  double modulus = 1.;
  LinearSolver linear_solver = LinearSolver::automatic;
};

/** The name of this task, to which the root calls; see ProcessGroup::call(). */
inline const std::string least_energy_task = "least energy";

/**
 * The part of another process than the root in LeastEnergy::solve(), once it is
 * called to it.
 */
void work_on_least_energy(const ProcessGroup &processes, Terminal &terminal);
} // namespace Voussoir

#endif
