// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/any_state.h>
#include <voussoir/statics/proximal_steps.h>
#include <voussoir/statics/solver_controls.h>
#include <voussoir/statics/yielding_joints.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
/** How many ways to cut joints that crush are tried. */
constexpr unsigned int n_rounds = 8;

/** Elastic rows that yield at their bounds. */
class YieldingJoint : public JointLaw
{
public:
  /** The references must outlive this object. */
  YieldingJoint(const BoundedRows &rows, const DiscreteProblem &problem)
      : rows(rows)
  {
    stiffness.reserve(rows.n_all_rows());
    origin.reserve(rows.n_all_rows());
    for (unsigned int e = 0; e < rows.joints().size(); ++e)
    {
      const double total = rows.joints()[e].stiffness();
      for (unsigned int r = 0; r < rows.n_contacts(); ++r)
      {
        const double share = rows.share(e, r);
        stiffness.push_back(share * total);
        origin.push_back(share * problem.tension(e));
      }
      stiffness.push_back(total);
      origin.push_back(0.);
    }
  }

  void find_forces(const unsigned int e,
                   const double *jumps,
                   double *forces) const override
  {
    for (unsigned int r = 0; r < rows.n_rows(); ++r)
      forces[r] = std::clamp(elastic(e, r, jumps), bounds(e, r).least,
                             bounds(e, r).greatest);
  }

  void find_second_derivatives(const unsigned int e,
                               const double *jumps,
                               double *second) const override
  {
    for (unsigned int r = 0; r < rows.n_rows(); ++r)
    {
      const double force = elastic(e, r, jumps);
      const bool yields =
          force < bounds(e, r).least || force > bounds(e, r).greatest;
      second[r] = yields ? 0. : stiffness[number(e, r)];
    }
  }

private:
  std::size_t number(const unsigned int e, const unsigned int r) const
  {
    return std::size_t(e) * rows.n_rows() + r;
  }
  const BoundedRows::Bounds &bounds(const unsigned int e,
                                    const unsigned int r) const
  {
    return rows.bounds()[number(e, r)];
  }
  /** The force without bounds, from that of the row without a jump. */
  double
  elastic(const unsigned int e, const unsigned int r, const double *jumps) const
  {
    return stiffness[number(e, r)] * jumps[r] - origin[number(e, r)];
  }

  const BoundedRows &rows;
  std::vector<double> stiffness, origin;
};

/** Newton's method, with one way to cut the joints. */
class Attempt
{
public:
  /** @param start n_dofs() numbers. */
  Attempt(const DiscreteProblem &problem,
          const BoundedRows &rows,
          const LinearSolver linear_solver,
          std::vector<double> start)
      : rows(rows), law(rows, problem), system(rows, linear_solver),
        newton(rows, law, system, std::move(start))
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

  const BoundedRows &rows;
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
  found.forces = rows.forces_of(forces);
  return found;
}
} // namespace

Solution minimise_yielding(const DiscreteProblem &problem,
                           const ElasticOrder &order,
                           const double displacement_unit,
                           std::vector<double> start,
                           Terminal &terminal)
{
  Assert(std::all_of(problem.joints().begin(), problem.joints().end(),
                     [](const auto &joint) { return joint.coefficient == 0.; }),
         dealii::ExcMessage("Rows of Coulomb's friction have other shares."));
  RowProblem by_rows(problem);
  std::vector<double> u = std::move(start);
  u.resize(problem.n_dofs(), 0.);
  unsigned int n_iterations = 0, n_evaluations = 0;
  std::optional<Solution> found, any;
  for (unsigned int round = 0; round < n_rounds && !found; ++round)
  {
    if (round > 0)
      by_rows.refine(u);
    Attempt attempt(problem, by_rows.rows(), order.linear_solver, std::move(u));
    found = attempt.minimise(order.tolerance, order.n_max_iterations, terminal);
    u = attempt.u();
    n_iterations += attempt.n_iterations();
    n_evaluations += attempt.n_evaluations();
    if (!found && !any)
      any = find_state_or_collapse(problem, order.n_max_iterations, terminal);
    // Strips that are cut otherwise may carry what these do not.
    if (any && !(any->converged() && by_rows.rows().has_strips()))
      break;
  }
  if (found)
  {
    problem.remove_rigid_motions(u);
    found->motion = problem.motion_of_cells(u, displacement_unit);
  }
  else
  {
    found = std::move(any);
    if (found->converged())
      found->selection = AnyState().selection();
  }
  found->n_iterations += n_iterations;
  found->n_evaluations += n_evaluations;
  return std::move(*found);
}
} // namespace Voussoir
