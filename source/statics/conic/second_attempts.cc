// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/second_attempts.h>
#include <voussoir/statics/problem/find_opening.h>

#include <algorithm>
#include <new>

namespace Voussoir
{
namespace
{
/**
 * The mean product, relative to the tolerance, with which forces count as those
 * of least cost, and the least that rounding lets all packings reach: forces
 * are then within 1e-7 of those that Newton's method finds (measured).
 */
constexpr double product_over_tolerance = 1e-2;
constexpr double smallest_product = 1e-12;
/** A product that rounding may keep from getting smaller. */
constexpr double product_near_rounding = 1e-9;

/** The product, and the imbalance, with which the load factor has no error. */
constexpr double product_of_load_factor = 1e-15;
constexpr double imbalance_of_load_factor = 1e-12;

/**
 * The load factor takes up to 30 iterations (measured: 100 to 5,000 cells, at
 * 0.1 to 2 of the limit load).
 */
constexpr unsigned int n_max_for_load_factor = 60;

/**
 * The same for approach_minimum(), measured: up to 26; and the product from
 * which Newton's method takes one or two steps.
 */
constexpr unsigned int n_max_to_approach = 40;
constexpr double product_of_approach = 1e-8;

/** The product with which forces count as those of least cost. */
double largest_product(const double tolerance)
{
  return std::max(product_over_tolerance * tolerance, smallest_product);
}

void show(const InteriorPoint &point, Terminal &terminal)
{
  terminal.iteration("Interior point",
                     text("iteration ", point.n_iterations(), ", imbalance ",
                          point.imbalance(), ", product ", point.product()));
}
} // namespace

std::vector<JointCost> elastic_costs(const DiscreteProblem &problem)
{
  std::vector<JointCost> costs;
  costs.reserve(problem.joints().size());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    costs.push_back({1. / problem.contact_stiffness(e),
                     1. / problem.joints()[e].stiffness(), 0.});
  return costs;
}

std::vector<double> approach_minimum(const DiscreteProblem &problem,
                                     const std::vector<JointCost> &costs,
                                     const double tolerance,
                                     unsigned int &n_iterations,
                                     Terminal &terminal)
{
  InteriorPoint point(problem, costs, InteriorPoint::Aim::near_least_cost);
  const auto is_near = [&]() {
    return point.imbalance() <= tolerance &&
           point.product() <= product_of_approach;
  };
  do
    show(point, terminal);
  while (point.n_iterations() < n_max_to_approach && point.step() &&
         !is_near() && !find_mechanism(problem, point.u()));
  n_iterations += point.n_iterations();
  return point.u();
}

Solution minimise_by_interior_point(const DiscreteProblem &problem,
                                    const std::vector<JointCost> &costs,
                                    const SolverControls &controls,
                                    const Solution &before,
                                    Terminal &terminal)
{
  InteriorPoint point(problem, costs, InteriorPoint::Aim::least_cost);
  Solution solution = before;
  std::vector<double> u;
  while (!solution.converged() && !solution.mechanism &&
         before.n_iterations + point.n_iterations() <
             controls.n_max_iterations &&
         point.step())
  {
    const double imbalance = point.imbalance(), product = point.product();
    show(point, terminal);
    if ((solution.mechanism = find_mechanism(problem, point.u())))
      solution.stop = Stop::Reason::collapse;
    else if (imbalance <= controls.tolerance &&
             product <= product_near_rounding)
    {
      // Forces are balanced also if rounding stops the method before it
      // converges.
      solution.stop = product <= largest_product(controls.tolerance)
                          ? Stop::Reason::converged
                          : Stop::Reason::rounding;
      solution.forces = point.forces();
      u = point.u();
    }
  }

  if (!u.empty())
  {
    problem.remove_rigid_motions(u);
    solution.u = std::move(u);
  }
  solution.n_iterations += point.n_iterations();
  solution.n_evaluations += point.n_iterations();
  solution.seconds["linear systems"] += point.seconds_of_systems();
  return solution;
}

std::optional<Mechanism>
find_collapse_by_load_factor(const DiscreteProblem &problem, Terminal &terminal)
{
  InteriorPoint point(problem, std::vector<JointCost>(problem.joints().size()),
                      InteriorPoint::Aim::load_factor);
  std::optional<Mechanism> mechanism;
  while (!mechanism && point.n_iterations() < n_max_for_load_factor &&
         point.step())
  {
    terminal.iteration("Load factor", text("iteration ", point.n_iterations(),
                                           ", factor ", point.load_factor(),
                                           ", product ", point.product()));
    mechanism = find_mechanism(problem, point.u());
    if (point.product() <= product_of_load_factor ||
        (point.load_factor() > 1. &&
         point.imbalance() <= imbalance_of_load_factor))
      break; // the load is carried, or no digits are left to tell
  }
  if (!mechanism && !(point.load_factor() > 1.))
    mechanism = find_mechanism_near(problem, point.u());
  return mechanism;
}

Solution try_second_attempts(const DiscreteProblem &problem,
                             const std::vector<JointCost> &costs,
                             const SolverControls &controls,
                             Solution solution,
                             Terminal &terminal)
{
  if (solution.converged() || solution.mechanism)
    return solution;
  try
  {
    if (!opening_of(problem).displacement.empty())
      solution.mechanism = find_collapse_by_load_factor(problem, terminal);
    if (solution.mechanism)
      solution.stop = Stop::Reason::collapse;
    else if (!costs.empty())
      return minimise_by_interior_point(problem, costs, controls, solution,
                                        terminal);
  }
  catch (const SolverError &)
  {
    // The first answer stands.
  }
  catch (const std::bad_alloc &)
  {
    // The first answer stands.
  }
  return solution;
}
} // namespace Voussoir
