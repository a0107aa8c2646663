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

  CollapsePair find(unsigned int n_max_iterations);

private:
  bool solve();
  /** What a programme maximises, without the cost. */
  SelfDual::Program program_of(const RowProblem &by_rows) const
  {
    return {by_rows.loads(dead, true), by_rows.loads(live, false), sense};
  }
  double excess() const;
  void take_step();
  std::vector<double> motion() const;

  const DiscreteProblem &problem;
  const std::vector<double> &dead, &live;
  const double sense;
  Terminal &terminal;
  /** The forces whose normal parts give the strengths, and these. */
  std::vector<double> before, limits;
  /** The change of normal forces by the last programme. */
  std::vector<double> last_change;
  double step = first_step;
  SelfDual::Point last_point;
  CollapsePair pair;
};

/** Maximise with the strengths of the forces before. */
bool PairSearch::solve()
{
  limits = limits_of_coulomb(problem, before);
  const DiscreteProblem of_tresca = problem.with_tresca(limits);
  RowProblem by_rows(of_tresca);
  const ForceRows &rows = by_rows.rows();
  std::vector<double> curvature(rows.n_all_rows(), 0.);
  SelfDual::Program program = program_of(by_rows);
  program.cost.assign(curvature.size(), 0.);
  program.has_curvature = true;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    for (unsigned int r = 0; r < problem.n_contacts(e); ++r)
    {
      const unsigned int row = rows.first_row(e) + r;
      curvature[row] = cost_of_change / problem.contact_stiffness(e);
      program.cost[row] = -curvature[row] * before[problem.first_row(e) + r];
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
  last_point = std::move(nearest);
  return true;
}

/** The motion of the last programme, whose cost has no gradient. */
std::vector<double> PairSearch::motion() const
{
  const DiscreteProblem of_tresca = problem.with_tresca(limits);
  RowProblem by_rows(of_tresca);
  return by_rows.of_size_one(
      mechanism_near(by_rows.forces(), program_of(by_rows), last_point).u);
}

/** The largest difference of a strength from that of the forces found. */
double PairSearch::excess() const
{
  const std::vector<double> own = limits_of_coulomb(problem, pair.forces);
  double largest = 0.;
  for (std::size_t e = 0; e < own.size(); ++e)
    largest = std::max(largest, std::abs(own[e] - limits[e]));
  return largest / std::max(largest_component(dead), largest_component(live));
}

/** Move on from the forces before, along their change. */
void PairSearch::take_step()
{
  std::vector<double> change = pair.forces;
  add(change, -1., before);
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    change[problem.first_row(e) + problem.n_contacts(e)] = 0.;
  if (!last_change.empty())
  {
    std::vector<double> difference = change;
    add(difference, -1., last_change);
    if (const double square = dot(difference, difference); square > 0.)
      step = std::clamp(-step * dot(last_change, difference) / square,
                        least_step, largest_step);
  }
  add(before, step, change);
  last_change = std::move(change);
}

CollapsePair PairSearch::find(const unsigned int n_max_iterations)
{
  double last_alpha = std::numeric_limits<double>::infinity();
  while (pair.n_programmes < n_max_programmes &&
         pair.n_iterations < n_max_iterations && solve())
  {
    pair.excess = excess();
    terminal.iteration(
        "Collapse without dilatancy",
        text("programme ", pair.n_programmes, ", change ", pair.excess));
    pair.is_found = std::abs(pair.alpha - last_alpha) <=
                        smallest_change_of_factor * std::abs(pair.alpha) &&
                    pair.excess <= smallest_excess;
    if (pair.is_found)
    {
      pair.u = motion();
      break;
    }
    last_alpha = pair.alpha;
    take_step();
  }
  return std::move(pair);
}
} // namespace

CollapsePair find_collapse_pair(const DiscreteProblem &problem,
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
