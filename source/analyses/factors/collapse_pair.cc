// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/anderson.h>
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/factors/collapse_pair.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/problem/coulomb_limits.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/**
 * delta, for loads of size one; the last where no other sequence ends, and that
 * of the pressures to start from. Measured, walls: from 1e-5 to 0.1 the factors
 * differ by 1e-3 of them at most, and programmes are fewest with the first.
 */
constexpr double cost_of_change = 1e-2, last_cost_of_change = 1e-3,
                 cost_of_pressure = 1e-6;
/** The strengths that Anderson's acceleration remembers. */
constexpr unsigned int depth = 5;
/** By how much a factor may be less than that with dilatancy to be as good. */
constexpr double good_loss = 1e-3;
/**
 * The error of a programme, about the square of that of its forces, that is
 * none, and one that will do. And the iterations without a lesser one.
 */
constexpr double error_of_programme = 1e-13, largest_error_of_programme = 1e-7;
constexpr unsigned int n_patience_of_programme = 4;
constexpr unsigned int n_max_of_programme = 100;
/** The programmes of one delta, and those in which the change is to halve. */
constexpr unsigned int n_max_programmes = 60, n_patience = 25;
/**
 * The change of the factor, over itself, and of a strength, over the largest
 * load, with which the sequence ends.
 */
constexpr double smallest_change_of_factor = 1e-8, smallest_excess = 1e-7;
/** What it may be where a sequence does not end. */
constexpr double largest_excess = 1e-6;
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
             const unsigned int n_max_iterations,
             Terminal &terminal)
      : problem(problem), dead(dead), live(live), sense(sense),
        n_max_iterations(n_max_iterations), terminal(terminal), before(forces)
  {}

  /** @param dilating the factor with dilatancy. */
  CollapsePair find(double dilating);

private:
  enum class Step
  {
    anderson,
    irons_and_tuck
  };
  /** A programme and its answer. */
  struct Programme
  {
    std::vector<double> limits;
    SelfDual::Point point;
    std::vector<double> forces;
    /**
     * The largest difference of a strength from that which the forces give,
     * over the largest load.
     */
    double excess = std::numeric_limits<double>::infinity();
  };

  void iterate(const std::vector<double> &start, double delta, Step kind);
  bool maximise(const DiscreteProblem &of_programme, double delta);
  bool solve(double delta);
  bool start_with_least_pressure();
  double excess() const;
  void take_step(Step kind);
  std::vector<double> motion() const;
  /** What a programme maximises, without the cost. */
  SelfDual::Program program_of(const RowProblem &by_rows) const
  {
    return {by_rows.loads(dead, true), by_rows.loads(live, false), sense};
  }

  const DiscreteProblem &problem;
  const std::vector<double> &dead, &live;
  const double sense;
  const unsigned int n_max_iterations;
  Terminal &terminal;
  /** The forces whose normal parts give the strengths. */
  std::vector<double> before;
  /** The last programme, the best of a sequence, and that of all. */
  Programme last, best, found;
  /** The change of normal forces by the programme before the last. */
  std::vector<double> last_change;
  double step = first_step;
  Anderson anderson{depth};
  unsigned int n_programmes = 0, n_iterations = 0;
};

/** Maximise with joints of some strengths, near the pressures before. */
bool PairSearch::maximise(const DiscreteProblem &of_programme,
                          const double delta)
{
  RowProblem by_rows(of_programme);
  const ForceRows &rows = by_rows.rows();
  std::vector<double> curvature(rows.n_all_rows(), 0.);
  SelfDual::Program program = program_of(by_rows);
  program.cost.assign(curvature.size(), 0.);
  program.has_curvature = true;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    problem.for_each_pressure(e, [&](const unsigned int r, const double share) {
      const unsigned int row = rows.first_row(e) + r;
      curvature[row] = delta / (problem.joints()[e].stiffness() * share);
      program.cost[row] = -curvature[row] * before[problem.first_row(e) + r];
    });
  ConicForces forces(rows, by_rows.forces().held_bodies(), curvature);
  forces.clear_without_force(program.cost);
  SelfDual search(forces, program);
  SelfDual::State state = SelfDual::State::running;
  double least = std::numeric_limits<double>::infinity();
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
    last.point = search.point();
  }
  n_iterations += search.n_iterations();
  ++n_programmes;
  if (!(least <= largest_error_of_programme))
    return false;
  last.forces = rows.forces_of(last.point.x);
  return true;
}

/** Maximise with the strengths of the forces before. */
bool PairSearch::solve(const double delta)
{
  last.limits = limits_of_coulomb(problem, before);
  if (!maximise(problem.with_tresca(last.limits), delta))
    return false;
  last.excess = excess();
  terminal.iteration(
      "Collapse without dilatancy",
      text("programme ", n_programmes, ", change ", last.excess));
  if (last.excess < best.excess)
    best = last;
  return true;
}

/** With dilatancy, which leaves the last forces. */
bool PairSearch::start_with_least_pressure()
{
  before.assign(before.size(), 0.);
  return maximise(problem, cost_of_pressure);
}

/** Of the last programme. */
double PairSearch::excess() const
{
  const std::vector<double> own = limits_of_coulomb(problem, last.forces);
  double largest = 0.;
  for (std::size_t e = 0; e < own.size(); ++e)
    largest = std::max(largest, std::abs(own[e] - last.limits[e]));
  return largest / std::max(largest_component(dead), largest_component(live));
}

/** Move on from the forces before, along their change. */
void PairSearch::take_step(const Step kind)
{
  if (kind == Step::anderson)
  {
    before = anderson.next(before, pressures_of(problem, last.forces));
    return;
  }
  std::vector<double> change = pressures_of(problem, last.forces);
  add(change, -1., before);
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

/** Solve programmes until the strengths are their own. */
void PairSearch::iterate(const std::vector<double> &start,
                         const double delta,
                         const Step kind)
{
  before = pressures_of(problem, start);
  best = {};
  step = first_step;
  last_change.clear();
  anderson.restart();
  double alpha = std::numeric_limits<double>::infinity();
  double excess_to_halve = alpha;
  unsigned int n_of_halving = n_programmes;
  for (unsigned int n = 0;
       n < n_max_programmes && n_programmes <= n_of_halving + n_patience &&
       n_iterations < n_max_iterations && solve(delta);
       ++n)
  {
    const double change = std::abs(last.point.alpha - alpha);
    alpha = last.point.alpha;
    if (last.excess <= smallest_excess &&
        change <= smallest_change_of_factor * std::abs(alpha))
      break;
    if (last.excess < 0.5 * excess_to_halve)
    {
      excess_to_halve = last.excess;
      n_of_halving = n_programmes;
    }
    take_step(kind);
  }
  if (best.excess <= largest_excess &&
      (found.forces.empty() ||
       sense * (best.point.alpha - found.point.alpha) > 0.))
    found = best;
}

/** The motion of what was found, whose cost has hardly a gradient. */
std::vector<double> PairSearch::motion() const
{
  const DiscreteProblem of_tresca = problem.with_tresca(found.limits);
  RowProblem by_rows(of_tresca);
  return by_rows.of_size_one(
      mechanism_near(by_rows.forces(), program_of(by_rows), found.point).u);
}

CollapsePair PairSearch::find(const double dilating)
{
  const std::vector<double> given = before;
  const auto look_from = [this](const std::vector<double> &start) {
    iterate(start, cost_of_change, Step::anderson);
    if (!(best.excess <= largest_excess))
      iterate(start, cost_of_change, Step::irons_and_tuck);
  };
  look_from(given);
  if (found.forces.empty() ||
      std::abs(dilating - found.point.alpha) > good_loss * std::abs(dilating))
    if (start_with_least_pressure())
      look_from(std::vector<double>(last.forces));
  if (found.forces.empty())
    iterate(given, last_cost_of_change, Step::irons_and_tuck);
  CollapsePair pair;
  pair.n_programmes = n_programmes;
  pair.n_iterations = n_iterations;
  pair.is_found = !found.forces.empty();
  if (!pair.is_found)
    return pair;
  pair.u = motion();
  pair.alpha = found.point.alpha;
  pair.forces = std::move(found.forces);
  return pair;
}
} // namespace

CollapsePair find_collapse_pair(const DiscreteProblem &problem,
                                const std::vector<double> &dead,
                                const std::vector<double> &live,
                                const double sense,
                                const std::vector<double> &forces,
                                const double alpha,
                                const unsigned int n_max_iterations,
                                Terminal &terminal)
{
  return PairSearch(problem, dead, live, sense, forces, n_max_iterations,
                    terminal)
      .find(alpha);
}
} // namespace Voussoir
