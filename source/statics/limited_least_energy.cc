// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/any_state.h>
#include <voussoir/statics/limited_least_energy.h>
#include <voussoir/statics/proximal_steps.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
/** The steps in which Newton's method gets there, or hardly ever does. */
constexpr unsigned int n_max_steps = 80;
/** The steps without progress that end it. */
constexpr unsigned int n_patience = 20;
/** How often joints that crush are cut, as where they are about to turn. */
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

/** Newton's method, once. */
class Attempt
{
public:
  /** @param start n_dofs() numbers. */
  Attempt(const DiscreteProblem &problem,
          const BoundedRows &rows,
          std::vector<double> start)
      : law(rows, problem), system(rows, LinearSolver::automatic),
        newton(rows, law, system, std::move(start))
  {}

  /** Step until the imbalance is @p wanted, or gets no smaller. */
  void minimise(double wanted, unsigned int n_max, Terminal &terminal);
  /** The displacement that it came to. */
  const std::vector<double> &u() const { return newton.u(); }
  /** The largest component of what is missing to a balance. */
  double imbalance() const { return newton.imbalance(); }
  /** The number of steps. */
  unsigned int n_iterations() const { return newton.n_iterations(); }
  /** The forces of the rows. */
  const std::vector<double> &forces() const { return newton.forces(); }

private:
  const YieldingJoint law;
  JointSystem system;
  Newton newton;
};

void Attempt::minimise(const double wanted,
                       const unsigned int n_max,
                       Terminal &terminal)
{
  ProximalSteps steps(newton);
  double least = std::numeric_limits<double>::infinity();
  unsigned int best = 0;
  while (imbalance() > wanted && n_iterations() < n_max &&
         n_iterations() <= best + n_patience)
  {
    if (imbalance() < least)
    {
      least = imbalance();
      best = n_iterations();
    }
    terminal.iteration("Newton", text("iteration ", n_iterations(),
                                      ", imbalance ", imbalance()));
    try
    {
      steps.advance();
    }
    catch (const NewtonFailure &)
    {
      // It grows without bound, as in a mechanism.
      return;
    }
  }
}
} // namespace

Solution LimitedLeastEnergy::select(const DiscreteProblem &problem,
                                    const SolverControls &controls,
                                    Terminal &terminal) const
{
  RowProblem by_rows(problem);
  const double unit = problem.stress_scale() * problem.length_scale();
  std::vector<double> u(problem.n_dofs(), 0.);
  if (controls.start)
    u = problem.unknowns_of(*controls.start, unit);
  const unsigned int n_max = std::min(n_max_steps, controls.n_max_iterations);
  unsigned int n_iterations = 0;
  std::optional<Solution> any;
  for (unsigned int round = 0; round < n_rounds; ++round)
  {
    Attempt attempt(problem, by_rows.rows(), std::move(u));
    attempt.minimise(controls.tolerance, n_max, terminal);
    n_iterations += attempt.n_iterations();
    u = attempt.u();
    if (attempt.imbalance() <= controls.tolerance)
    {
      Solution found;
      found.stop = Stop::Reason::converged;
      found.n_iterations = found.n_evaluations = n_iterations;
      found.forces = by_rows.rows().forces_of(attempt.forces());
      problem.remove_rigid_motions(u);
      found.motion = problem.motion_of_cells(u, unit);
      return found;
    }
    if (!any)
      any =
          find_state_or_collapse(problem, controls.n_max_iterations, terminal);
    // Strips that are cut otherwise may carry what these do not.
    if (!any->converged() || !by_rows.rows().has_strips())
      break;
    by_rows.refine(u);
  }
  any->n_iterations += n_iterations;
  return std::move(*any);
}
} // namespace Voussoir
