// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/newton.h>
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/energy/barrier_problem.h>
#include <voussoir/statics/paper/analytic_centre.h>
#include <voussoir/statics/problem/equilibrate.h>
#include <voussoir/statics/problem/sufficient_strengths.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** The shifts of fixed_joints(): from, to, and the ratio of one to the next. */
constexpr double first_shift_of_centre = 1e-4, shift_ratio = 1e-2;
/** The smaller, the closer to the limit of its strength a joint may be. */
constexpr double last_shifts[] = {1e-10, 1e-14, 1e-18};
/**
 * The factor by which a force falls from one shift to the next: the root of
 * their ratio where it vanishes, one where it does not; this is half way.
 */
constexpr double half_way = 0.316;
constexpr double fixed_joints_decrement = 1e-4;
constexpr unsigned int n_max_fixed_joints_steps = 30;

/**
 * Find the joints where all admissible and balanced states have p = 0 or
 * |q| = s_e |e|.
 *
 * With the proximal term shift / 2 |u|^2 there is a minimum even where the
 * displacement would grow without end. As the shift goes to zero, p and
 * s_e |e| - |q| then fall with its square root in those joints, and tend to
 * positive limits in all others.
 *
 * @return nothing if a minimum was not reached.
 */
std::optional<std::vector<signed char>>
fixed_joints(const DiscreteProblem &problem,
             const BarrierJoint &law,
             const double last_shift,
             const unsigned int n_max_steps,
             Newton &newton)
{
  const std::vector<double> origin(problem.n_dofs(), 0.);
  std::vector<signed char> fixed(problem.n_all_rows());
  // The force of a contact, the slack of friction.
  std::vector<double> before(problem.n_all_rows(), 1.);
  const auto vanishes = [](double &previous, const double now) {
    const double factor = now / previous;
    previous = now;
    return factor < half_way;
  };

  for (double shift = first_shift_of_centre; shift >= last_shift;
       shift *= shift_ratio)
  {
    unsigned int n_steps = 0;
    do
    {
      if (n_steps++ == n_max_fixed_joints_steps ||
          newton.n_iterations() >= n_max_steps)
        return {};
      newton.step(shift, origin);
    } while (!(newton.decrement() <= fixed_joints_decrement));

    for (unsigned int e = 0; e < problem.joints().size(); ++e)
    {
      std::size_t k = problem.first_row(e);
      for (unsigned int r = 0; r < problem.n_contacts(e); ++r, ++k)
        fixed[k] = vanishes(before[k], -newton.forces()[k]) ? 1 : 0;
      const double sliding = newton.jumps()[k];
      fixed[k] = 0;
      if (problem.limit(e) > 0. && vanishes(before[k], law.slack(e, sliding)))
        fixed[k] = sliding > 0. ? 1 : -1;
    }
  }
  return fixed;
}

/**
 * Where no centre was found, as very close to the limit: the loads collapse, or
 * forces that miss the balance give way to others that do not. The solution is
 * not called a centre.
 */
void settle_near_limit(const DiscreteProblem &problem,
                       const SolverControls &controls,
                       Solution &solution,
                       Terminal &terminal)
{
  Solution any =
      find_state_or_collapse(problem, controls.n_max_iterations, terminal);
  if (any.mechanism)
  {
    solution.mechanism = std::move(any.mechanism);
    solution.stop = Stop::Reason::collapse;
  }
  else if (any.converged() &&
           (solution.forces.empty() ||
            largest_component(imbalance(problem, solution.forces)) >
                controls.tolerance))
    solution.forces = std::move(any.forces);
}
} // namespace

std::string AnalyticCentre::selection() const
{
  return std::string("analytic centre of the admissible states, with ") +
         (weights == BarrierWeights::equal
              ? "equal weights"
              : "each interface weighted by |e| d_e") +
         "; strengths count up to 100 times the mean stress of the loads where "
         "that is enough";
}

void AnalyticCentre::add_parameters(dealii::ParameterHandler &prm)
{
  add_choice<BarrierWeights>(
      prm, "Barrier weights", weights,
      {{BarrierWeights::edge_area, "edge area",
        "|e| d_e, which spreads stress evenly."},
       {BarrierWeights::equal, "equal",
        "one, the limit that an interior-point solver of the linear program "
        "heads for; short edges may carry very large stresses."}},
      "What each interface counts.");
}

Solution AnalyticCentre::select(const DiscreteProblem &problem,
                                const SolverControls &controls,
                                Terminal &terminal) const
{
  require_interior(problem, name());
  Solution solution = solve_with_sufficient_strengths(
      problem, controls,
      [&](const DiscreteProblem &at_most, const SolverControls &rest) {
        return find_centre(at_most, rest, terminal);
      });
  if (!solution.converged() && !solution.mechanism)
    settle_near_limit(problem, controls, solution, terminal);
  return solution;
}

Solution AnalyticCentre::find_centre(const DiscreteProblem &problem,
                                     const SolverControls &controls,
                                     Terminal &terminal) const
{
  const SharedProblem whole(problem);
  BarrierJoint law(problem, weights);
  JointSystem system(problem, LinearSolver::automatic);
  unsigned int n_iterations = 0, n_evaluations = 0;
  const auto solve = [&]() {
    Solution found =
        minimise_barrier(whole, law, system, controls.tolerance,
                         controls.n_max_iterations - n_iterations, terminal);
    n_iterations += found.n_iterations;
    n_evaluations += found.n_evaluations;
    return found;
  };

  Solution solution = solve();
  for (const double last_shift : last_shifts)
  {
    if (solution.converged() || solution.mechanism ||
        n_iterations >= controls.n_max_iterations)
      break;
    law = BarrierJoint(problem, weights);
    Newton newton(problem, law, system, start_of_barrier(whole, law));
    const auto fixed =
        fixed_joints(problem, law, last_shift,
                     controls.n_max_iterations - n_iterations, newton);
    n_iterations += newton.n_iterations();
    n_evaluations += newton.n_evaluations();
    if (fixed && n_iterations < controls.n_max_iterations)
    {
      law.fixed = *fixed;
      solution = solve();
    }
  }

  solution.n_iterations = n_iterations;
  solution.n_evaluations = n_evaluations;
  // The fixed forces of the joints are known only if the rest has a centre.
  if (solution.converged())
    for (unsigned int e = 0; e < problem.joints().size(); ++e)
    {
      const auto first = law.fixed.begin() + problem.first_row(e);
      const auto friction = first + problem.n_contacts(e);
      solution.never_pressed.push_back(std::count(first, friction, 0) == 0);
      solution.always_sliding.push_back(*friction != 0);
    }
  else if (!solution.mechanism && n_iterations < controls.n_max_iterations)
    solution.stop = Stop::Reason::no_centre;
  return solution;
}
} // namespace Voussoir
