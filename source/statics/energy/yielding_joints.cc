// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/energy/proximal_steps.h>
#include <voussoir/statics/energy/yielding_joint.h>
#include <voussoir/statics/energy/yielding_joints.h>
#include <voussoir/statics/problem/solver_controls.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
/** Newton's method for these joints. */
class Attempt
{
public:
  /** @param start n_dofs() numbers. */
  Attempt(const DiscreteProblem &problem,
          const LinearSolver linear_solver,
          std::vector<double> start)
      : problem(problem), structure(with_middle(problem)),
        law(structure, problem), system(structure, linear_solver),
        newton(structure, law, system, std::move(start))
  {}

  /**
   * Step until the imbalance is @p wanted, or gets no smaller.
   *
   * @return the forces with the least imbalance, if that is @p wanted or near
   *   rounding.
   */
  std::optional<Solution>
  minimise(double wanted, unsigned int n_max, Terminal &terminal);
  /** The displacement that it came to. */
  const std::vector<double> &u() const { return newton.u(); }
  /** @{ */
  unsigned int n_iterations() const { return newton.n_iterations(); }
  unsigned int n_evaluations() const { return newton.n_evaluations(); }
  /** @} */

private:
  bool step(ProximalSteps &steps);

  const DiscreteProblem &problem;
  const Structure structure;
  const YieldingJoint law;
  JointSystem system;
  Newton newton;
};

/** @return false if there is no next step: it grows as in a mechanism. */
bool Attempt::step(ProximalSteps &steps)
{
  try
  {
    steps.advance();
    return true;
  }
  catch (const NewtonFailure &)
  {
    return false;
  }
}

std::optional<Solution> Attempt::minimise(const double wanted,
                                          const unsigned int n_max,
                                          Terminal &terminal)
{
  ProximalSteps steps(newton);
  double least = newton.imbalance();
  std::vector<double> forces = newton.forces();
  for (unsigned int best = 0; least > wanted && n_iterations() < n_max &&
                              n_iterations() <= best + n_stalled_iterations &&
                              step(steps);)
  {
    terminal.iteration("Newton", text("iteration ", n_iterations(),
                                      ", imbalance ", newton.imbalance()));
    if (!(newton.imbalance() < least))
      continue;
    least = newton.imbalance();
    best = n_iterations();
    forces = newton.forces();
  }
  if (!(least <= std::max(wanted, imbalance_near_rounding)))
    return {};
  Solution found;
  found.stop =
      least <= wanted ? Stop::Reason::converged : Stop::Reason::rounding;
  found.forces = without_middle(problem, forces);
  return found;
}
} // namespace

Solution minimise_yielding(const DiscreteProblem &problem,
                           const ElasticOrder &order,
                           std::vector<double> start,
                           Terminal &terminal)
{
  Assert(std::all_of(problem.joints().begin(), problem.joints().end(),
                     [](const auto &joint) { return joint.coefficient == 0.; }),
         dealii::ExcMessage("Rows of Coulomb's friction have other shares."));
  start.resize(problem.n_dofs(), 0.);
  Attempt attempt(problem, order.linear_solver, std::move(start));
  std::optional<Solution> found =
      attempt.minimise(order.tolerance, order.n_max_iterations, terminal);
  if (found)
  {
    std::vector<double> u = attempt.u();
    problem.remove_rigid_motions(u);
    found->u = std::move(u);
  }
  else
  {
    found = find_state_or_collapse(problem, order.n_max_iterations, terminal);
    if (found->converged())
      found->selection = FeasibleState().selection();
  }
  found->n_iterations += attempt.n_iterations();
  found->n_evaluations += attempt.n_evaluations();
  return std::move(*found);
}
} // namespace Voussoir
