// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_least_energy_h
#define voussoir_statics_least_energy_h

#include <voussoir/statics/formulation.h>
#include <voussoir/statics/joint_law.h>
#include <voussoir/statics/joint_system.h>
#include <voussoir/statics/shared_problem.h>

#include <optional>

namespace Voussoir
{
/**
 * The law of elastic joints that open and slide.
 *
 * Their stiffness is k_e = |e| / d_e:
 *
 *     energy = k_e min(y, 0)^2 / 2 + Huber(x),
 *
 * where y and x are the normal and the tangential jump and Huber's function is
 * k_e x^2 / 2 up to the slope s_e |e| and continues with that slope. The forces
 * are admissible for any jump.
 */
class ElasticJoint : public JointLaw
{
public:
  /** @param structure has the joints; it must outlive this object. */
  explicit ElasticJoint(const Structure &structure);

  Jump force(unsigned int e, const Jump &jump) const override;
  Jump second_derivative(unsigned int e, const Jump &jump) const override;

private:
  const Structure &structure;
};

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
 * that of ElasticJoint, which Newton's method solves.
 */
class LeastEnergy : public Formulation
{
public:
  std::string name() const override;
  std::string meaning() const override;
  std::string selection() const override;
  void add_parameters(dealii::ParameterHandler &prm) override;

private:
  Solution select(const DiscreteProblem &problem,
                  const SolverControls &controls,
                  Terminal &terminal) const override;

  double modulus = 1.;
  LinearSolver linear_solver = LinearSolver::automatic;
};

/**
 * The part of another process than the root in LeastEnergy::solve(), once it is
 * called to Team::Task::least_energy.
 */
void assist_least_energy(const Team &team, Terminal &terminal);

/**
 * Look for a proof that the load is not carried, in the displacements of the
 * elastic joints, which grow along a mechanism if there is one. Slower than
 * find_collapse_by_barrier(), but it needs no opening. Collective.
 *
 * @return the proof, or none if none was found, which proves nothing.
 * @throws SolverError if a linear system cannot be solved.
 */
std::optional<Mechanism> find_collapse_by_springs(const SharedProblem &problem,
                                                  Terminal &terminal);
} // namespace Voussoir

#endif
