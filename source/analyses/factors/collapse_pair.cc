// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/factors/collapse_pair.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/energy/coulomb_state.h>
#include <voussoir/statics/energy/energy_program.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * delta, for loads of size one. Measured, walls: from 1e-5 to 0.1 the factors
 * differ by 1e-3 of them at most, and programmes are fewest about here.
 */
constexpr double cost_of_change = 1e-2;
/**
 * The error of a programme, about the square of that of its forces, that is
 * none, and one that will do. And the iterations without a lesser one.
 */
constexpr double error_of_programme = 1e-13, largest_error_of_programme = 1e-7;
constexpr unsigned int n_patience_of_programme = 4;
constexpr unsigned int n_max_of_programme = 100, n_max_programmes = 100;
/**
 * The change of the factor, over itself, and of a strength, over the largest
 * load, with which the sequence ends.
 */
constexpr double smallest_change_of_factor = 1e-8, smallest_excess = 1e-7;
/** The step to the next forces, over their change: first, least and largest. */
constexpr double first_step = 0.5, least_step = 0.2, largest_step = 4.;

/** One search; an object is used once. */
class PairSearch
{
public:
  PairSearch(const DiscreteProblem &problem,
             const std::vector<double> &dead,
             const std::vector<double> &live,
             const double sense,
             const std::vector<double> &forces,
             Terminal &terminal)
      : problem(problem), dead(dead), live(live), sense(sense),
        terminal(terminal), before(forces)
  {}

  std::optional<CollapsePair> find(unsigned int n_max_iterations);

private:
  bool solve();
  void go_on(const std::vector<double> &last_change);
  std::vector<double> change() const;

  const DiscreteProblem &problem;
  const std::vector<double> &dead, &live;
  const double sense;
  Terminal &terminal;
  /** The forces whose normal parts give the strengths. */
  std::vector<double> before;
  double step = first_step;
  CollapsePair pair;
};

bool PairSearch::solve()
{
  pair.limits = limits_of_coulomb(problem, before);
  const DiscreteProblem of_tresca = problem.with_tresca(pair.limits);
  RowProblem by_rows(of_tresca);
  const ForceRows &rows = by_rows.rows();
  std::vector<double> curvature(rows.n_all_rows(), 0.);
  SelfDual::Program program = {by_rows.loads(dead, true),
                               by_rows.loads(live, false), sense};
  program.cost.assign(curvature.size(), 0.);
  program.has_curvature = true;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r)
    {
      const unsigned int row = rows.first_row(e) + r;
      curvature[row] = cost_of_change / problem.contact_stiffness(e);
      program.cost[row] =
          -curvature[row] * before[problem.first_row(e) + r];
    }
  ConicForces forces(rows, by_rows.forces().held_bodies(), curvature);
  forces.clear_without_force(program.cost);
  SelfDual search(forces, program);
  SelfDual::State state = SelfDual::State::running;
  double least = std::numeric_limits<double>::infinity();
  SelfDual::Point nearest;
  unsigned int n_in_vain = 0;
  while (state == SelfDual::State::running && !(least <= error_of_programme) &&
         n_in_vain < n_patience_of_programme &&
         search.n_iterations() < n_max_of_programme)
  {
    state = search.step();
    if (!(search.merit() < least))
    {
      n_in_vain += least <= largest_error_of_programme;
      continue;
    }
    n_in_vain = 0;
    least = search.merit();
    nearest = search.point();
  }
  pair.n_iterations += search.n_iterations();
  ++pair.n_programmes;
  if (!(least <= largest_error_of_programme))
    return false;
  pair.alpha = nearest.alpha;
  pair.forces = rows.forces_of(nearest.x);
  return true;
}

/** Of the forces that were found from those before. */
std::vector<double> PairSearch::change() const
{
  std::vector<double> difference = pair.forces;
  add(difference, -1., before);
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    difference[problem.first_row(e) + problem.n_contacts(e)] = 0.;
  return difference;
}

/** Take the next step. */
void PairSearch::go_on(const std::vector<double> &last_change)
{
  const std::vector<double> now = change();
  if (!last_change.empty())
  {
    std::vector<double> difference = now;
    add(difference, -1., last_change);
    if (const double square = dot(difference, difference); square > 0.)
      step = std::clamp(-step * dot(last_change, difference) / square,
                        least_step, largest_step);
  }
  add(before, step, now);
}

std::optional<CollapsePair>
PairSearch::find(const unsigned int n_max_iterations)
{
  const double size = std::max(largest_component(dead), largest_component(live));
  std::vector<double> last_change;
  double last_alpha = std::numeric_limits<double>::infinity();
  while (pair.n_programmes < n_max_programmes &&
         pair.n_iterations < n_max_iterations)
  {
    if (!solve())
      return {};
    const std::vector<double> own = limits_of_coulomb(problem, pair.forces);
    pair.excess = 0.;
    for (std::size_t e = 0; e < own.size(); ++e)
      pair.excess =
          std::max(pair.excess, std::abs(own[e] - pair.limits[e]) / size);
    terminal.iteration("Collapse", text("programme ", pair.n_programmes,
                                        ", factor ", pair.alpha,
                                        ", change ", pair.excess));
    if (std::abs(pair.alpha - last_alpha) <=
            smallest_change_of_factor * std::abs(pair.alpha) &&
        pair.excess <= smallest_excess)
      break;
    last_alpha = pair.alpha;
    const std::vector<double> now = change();
    go_on(last_change);
    last_change = now;
  }
  return std::move(pair);
}
} // namespace

std::optional<CollapsePair>
find_collapse_pair(const DiscreteProblem &problem,
                   const std::vector<double> &dead,
                   const std::vector<double> &live,
                   const double sense,
                   const std::vector<double> &forces,
                   const unsigned int n_max_iterations,
                   Terminal &terminal)
{
  return PairSearch(problem, dead, live, sense, forces, terminal)
      .find(n_max_iterations);
}
} // namespace Voussoir
