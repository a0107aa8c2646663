// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/opening_program.h>
#include <voussoir/statics/conic/self_dual.h>
#include <voussoir/statics/problem/opening_proofs.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
/**
 * The most iterations; it takes 5 to 30 (measured), and 80 in a closed box with
 * a hole in its lid.
 */
constexpr unsigned int n_max_of_opening = 100;
/** The error of the program at which its pressures are those of the minimum. */
constexpr double error_of_end = 1e-6;
/** What pressures leave on a body, over the largest, to be worth balancing. */
constexpr double imbalance_worth_correcting = 1e-2;
/**
 * The rounds of a correction, the part of what was left that another one may
 * leave if it is worthwhile, and the stopping criteria of the solver.
 */
constexpr unsigned int n_rounds_of_balance = 4, n_gradients_of_balance = 15;
constexpr double worthwhile_part = 0.1, reduction_of_left = 1e-15;

/** The program of one problem. */
class OpeningSearch
{
public:
  explicit OpeningSearch(const DiscreteProblem &problem)
      : problem(problem), rows(problem),
        forces(rows, held_bodies(), curvatures())
  {}

  Opening find(Terminal &terminal);

private:
  std::vector<bool> held_bodies() const
  {
    std::vector<bool> held;
    for (unsigned int b = 0; b < problem.n_bodies(); ++b)
      held.push_back(problem.is_held(b));
    return held;
  }
  std::vector<double> curvatures() const;
  SelfDual::Program program() const;
  std::vector<double> balanced_pressures(std::vector<double> x);

  const DiscreteProblem &problem;
  const ForceRows rows;
  ConicForces forces;
};

std::vector<double> OpeningSearch::curvatures() const
{
  std::vector<double> q(problem.n_all_rows());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    problem.for_each_pressure(e, [&](const unsigned int r, const double share) {
      q[problem.first_row(e) + r] =
          1. / (share * problem.joints()[e].stiffness());
    });
  return q;
}

SelfDual::Program OpeningSearch::program() const
{
  std::vector<double> distance(problem.n_all_rows());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    problem.for_each_pressure(e, [&](const unsigned int r, double) {
      distance[problem.first_row(e) + r] = problem.joints()[e].distance;
    });
  return {std::vector<double>(problem.n_dofs(), 0.),
          {},
          1.,
          std::move(distance),
          true};
}

/**
 * The pressures of rows with the forces @p x, corrected to a self-stress, those
 * that are small next to not at all; empty if that is none.
 */
std::vector<double> OpeningSearch::balanced_pressures(std::vector<double> x)
{
  std::vector<double> left = forces.on_bodies(x), best = x;
  double least = largest_component(left);
  if (!(least <= imbalance_worth_correcting * largest_component(x)))
    return {};
  for (unsigned int n = 0; n < n_rounds_of_balance && least > 0.; ++n)
  {
    std::vector<double> squares;
    for (const double force : x)
      squares.push_back(force * force);
    if (!forces.prepare_diagonal(squares))
      break;
    const std::vector<double> along = forces.along(
        forces
            .solve(left, 0., reduction_of_left * least, n_gradients_of_balance)
            .u);
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] = std::min(x[k] - squares[k] * along[k], 0.);
    left = forces.on_bodies(x);
    const double size = largest_component(left);
    const bool is_worthwhile = size <= worthwhile_part * least;
    if (size < least)
    {
      best = x;
      least = size;
    }
    if (!is_worthwhile)
      break;
  }
  for (double &force : best)
    force = std::max(-force, 0.);
  return is_self_stress(problem, best) ? best : std::vector<double>();
}

Opening OpeningSearch::find(Terminal &terminal)
{
  // What is not a number is no proof.
  const InvalidOperationsAllowed allowed;
  SelfDual search(forces, program());
  SelfDual::State state = SelfDual::State::running;
  unsigned int n_before_balance = 1;
  while (state == SelfDual::State::running &&
         search.n_iterations() < n_max_of_opening)
  {
    state = search.step();
    terminal.iteration(
        "Interior point",
        text("iteration ", search.n_iterations(), ", error ", search.merit()));
    SelfDual::Point point = search.point();
    if (opens_all_joints(problem, point.u))
      return {std::move(point.u), {}};
    if (search.n_iterations() < n_before_balance &&
        !(search.merit() < error_of_end))
      continue;
    std::vector<double> p = balanced_pressures(std::move(point.x));
    if (!p.empty())
      return {{}, std::move(p)};
    n_before_balance *= 2; // each takes a factorisation or more
  }
  return {};
}
} // namespace

Opening find_opening_in_space(const DiscreteProblem &problem,
                              Terminal &terminal)
{
  if (std::optional<Opening> opening = opening_without_search(problem))
    return std::move(*opening);
  return OpeningSearch(problem).find(terminal);
}
} // namespace Voussoir
