// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/paper/displacement_program.h>
#include <voussoir/statics/paper/linear_program.h>
#include <voussoir/statics/problem/equilibrate.h>
#include <voussoir/statics/problem/find_opening.h>
#include <voussoir/statics/problem/sufficient_strengths.h>

#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * The products of constraints and multipliers to stop at where rounding spoils
 * smaller ones. Where a load is carried u goes to zero with them, and the
 * digits of the linear systems, but the multipliers tend to be the same for
 * all: the problem is homogeneous.
 */
constexpr double early_product = 1e-4;

/** Ipopt's damping times them, which stationarity ends with, over its
 * tolerance. */
constexpr double damping_of_tolerance = 0.1;

/**
 * The unknowns are u, then v_e of the joints that have a strength. The rows of
 * the constraints are [u]_e . n_e of all contacts, then v_e - [u]_e . t_e and
 * v_e + [u]_e . t_e of each joint with a strength.
 */
class HardFrictionProgram : public DisplacementProgram
{
public:
  explicit HardFrictionProgram(const DiscreteProblem &problem)
      : problem(problem)
  {
    for (unsigned int e = 0; e < problem.joints().size(); ++e)
      if (problem.limit(e) > 0.)
        rough.push_back(e);
  }

  /** The problem's opening, and v_e = d_e above its least. */
  std::vector<double> start() const override
  {
    std::vector<double> x = opening_of(problem).displacement;
    x.resize(n_unknowns());
    for (unsigned int k = 0; k < rough.size(); ++k)
      x[problem.n_dofs() + k] = problem.joints()[rough[k]].distance +
                                std::abs(problem.sliding(rough[k], x.data()));
    return x;
  }

  double value(const double *x) override
  {
    long double sum = -problem.work(x);
    for (unsigned int k = 0; k < rough.size(); ++k)
      sum += problem.limit(rough[k]) * x[problem.n_dofs() + k];
    return sum;
  }

  std::vector<double> gradient(const double * /*x*/) override
  {
    std::vector<double> g(n_unknowns());
    for (unsigned int k = 0; k < problem.n_dofs(); ++k)
      g[k] = -problem.loads()[k];
    for (unsigned int k = 0; k < rough.size(); ++k)
      g[problem.n_dofs() + k] = problem.limit(rough[k]);
    return g;
  }

  std::vector<Entry> hessian(const double * /*x*/) const override { return {}; }

  unsigned int n_constraints() const override
  {
    return n_contacts() + 2 * rough.size();
  }

  std::vector<Entry> constraints() const override
  {
    std::vector<Entry> entries;
    add_opening_entries(problem, entries);
    for (unsigned int k = 0; k < rough.size(); ++k)
      for (const int sign : {-1, 1})
      {
        const unsigned int row = forward_row(k) + (sign > 0 ? 1 : 0);
        add_jump_entries(problem, rough[k], problem.n_contacts(rough[k]), sign,
                         row, entries);
        entries.push_back({row, problem.n_dofs() + k, 1.});
      }
    return entries;
  }
  /** Of each row of each joint, from the multipliers, which are not positive.
   */
  std::vector<double> forces(const std::vector<double> &multipliers) const
  {
    std::vector<double> forces(problem.n_all_rows());
    set_normal_forces(problem, multipliers, forces);
    for (unsigned int k = 0; k < rough.size(); ++k)
    {
      // The two multipliers add up to minus the limit, but for rounding.
      const unsigned int e = rough[k];
      forces[problem.first_row(e) + problem.n_contacts(e)] = std::clamp(
          multipliers[forward_row(k) + 1] - multipliers[forward_row(k)],
          -problem.limit(e), problem.limit(e));
    }
    return forces;
  }

private:
  unsigned int n_unknowns() const { return problem.n_dofs() + rough.size(); }

  unsigned int n_contacts() const { return problem.n_all_contacts(); }
  /** The row of v_e >= [u]_e . t_e; that of v_e >= -[u]_e . t_e is next. */
  unsigned int forward_row(const unsigned int k) const
  {
    return n_contacts() + 2 * k;
  }

  const DiscreteProblem &problem;
  /** The joints with a strength. */
  std::vector<unsigned int> rough;
};

/**
 * Where Ipopt does not converge it is asked to stop early. Whether it calls
 * that converged depends on the processor, and says little of the forces.
 */
Solution solve_linear_program(const DiscreteProblem &problem,
                              const SolverControls &controls,
                              Terminal &terminal)
{
  HardFrictionProgram program(problem);
  IpoptControls ipopt{controls.tolerance, controls.n_max_iterations};
  const auto attempt = [&] {
    ProgramResult result = solve_program(problem, program, ipopt, terminal);
    if (!result.solution.mechanism)
      result.solution.forces = program.forces(result.multipliers);
    return result.solution;
  };
  Solution found = attempt();
  if (found.mechanism || found.converged())
    return found;
  ipopt.mu_target = early_product;
  ipopt.damping = damping_of_tolerance * controls.tolerance / early_product;
  Solution early = attempt();
  const bool is_better =
      early.mechanism || early.converged() ||
      largest_component(imbalance(problem, early.forces)) <
          largest_component(imbalance(problem, found.forces));
  return is_better ? early : found;
}
} // namespace

Solution LinearProgram::select(const DiscreteProblem &problem,
                               const SolverControls &controls,
                               Terminal &terminal) const
{
  require_interior(problem, name());
  return solve_with_sufficient_strengths(
      problem, controls,
      [&](const DiscreteProblem &at_most, const SolverControls &rest) {
        return solve_linear_program(at_most, rest, terminal);
      });
}
} // namespace Voussoir
