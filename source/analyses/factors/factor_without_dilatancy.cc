// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/analyses/factors/collapse_pair.h>
#include <voussoir/analyses/factors/factor_without_dilatancy.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/problem/discretise.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
/** The distance of a factor with a state from one without, over the bound. */
constexpr double smallest_width = 1e-6;

/** The shares of the bound that are tried before the bisection. */
constexpr unsigned int n_shares = 8;

/** The search for states at factors of the live loads; see CoulombState. */
class StatesAtFactors
{
public:
  StatesAtFactors(const Scene &dead,
                  const Scene &live,
                  const CoulombState &formulation,
                  const SolverControls &controls,
                  Terminal &terminal)
      : problem(discretise(dead.is_loaded() ? dead : live)),
        dead(discretise_loads(problem, dead)),
        live(discretise_loads(problem, live)), formulation(formulation),
        controls(controls), terminal(terminal)
  {}

  /** Look for a state at @p factor, and keep it if there is one. */
  bool has_state(double factor);
  /** Look at shares of @p bound, and then beside the greatest with a state. */
  double find_greatest(double bound);
  /** The factors that were looked at so far. */
  FactorTrials trials() const;

  const DiscreteProblem problem;
  /** The last state. */
  std::optional<Solution> found;
  unsigned int n_iterations = 0;

private:
  const std::vector<double> dead, live;
  const CoulombState &formulation;
  SolverControls controls;
  Terminal &terminal;
  std::vector<double> with_state, without_state;
};

bool StatesAtFactors::has_state(const double factor)
{
  std::vector<double> loads = dead;
  add(loads, factor, live);
  const DiscreteProblem at_factor = problem.with_loads(loads);
  controls.start = found ? &*found : nullptr;
  std::string failure;
  std::optional<Solution> state =
      formulation.find(at_factor, controls, failure, terminal);
  terminal.iteration(
      "Load factor",
      text("factor ", factor, ": ",
           state ? text(state->passes.n, " passes") : "no state, " + failure));
  (state ? with_state : without_state).push_back(factor);
  if (!state)
    return false;
  n_iterations += state->n_iterations;
  found = std::move(state);
  return true;
}

double StatesAtFactors::find_greatest(const double bound)
{
  if (bound == 0.)
    return 0.;
  const auto share = [bound](const unsigned int k) {
    return bound * k / n_shares;
  };
  unsigned int greatest = 0;
  for (unsigned int k = 1; k <= n_shares; ++k)
    if (has_state(share(k)))
      greatest = k;
  double carried = share(greatest);
  double beyond = share(std::min(greatest + 1, n_shares));
  while (std::abs(beyond - carried) > smallest_width * std::abs(bound))
  {
    const double middle = 0.5 * (carried + beyond);
    (has_state(middle) ? carried : beyond) = middle;
  }
  return carried;
}

FactorTrials StatesAtFactors::trials() const
{
  FactorTrials sorted = {with_state, without_state};
  for (auto *const factors : {&sorted.with_state, &sorted.without_state})
    std::sort(factors->begin(), factors->end(),
              [](const double a, const double b) {
                return std::abs(a) < std::abs(b);
              });
  return sorted;
}
} // namespace

LoadFactorAnswer
find_factor_without_dilatancy(const Scene &dead,
                              const Scene &live,
                              const CoulombState &formulation,
                              const SolverControls &controls,
                              const LoadFactorControls &factor_controls,
                              Terminal &terminal)
{
  LoadFactorAnswer answer =
      find_load_factor(dead, live, factor_controls, terminal);
  // Where pressure alone balances the live loads there is nothing to look for.
  if (!answer.factor || answer.factor->is_unbounded)
    return answer;
  LoadFactor &factor = *answer.factor;
  {
    const DiscreteProblem p(discretise(dead.is_loaded() ? dead : live));
    std::vector<double> d = discretise_loads(p, dead), l = discretise_loads(p, live);
    for (double &x : l) x *= factor.unit;
    const std::optional<CollapsePair> pair = find_collapse_pair(p, d, l, factor_controls.greatest ? 1. : -1., nondimensional_forces(p, factor.forces), 5000, terminal);
    if (pair) fprintf(stderr, "PAIR %.8g of %.8g : %.6f excess %g programmes %u its %u\n", pair->alpha * factor.unit, factor.carried, pair->alpha * factor.unit / factor.carried, pair->excess, pair->n_programmes, pair->n_iterations);
    else fprintf(stderr, "PAIR none\n");
  }
  StatesAtFactors states(dead, live, formulation, controls, terminal);
  if (!states.has_state(0.))
    throw SolverError("The load factor was not found: the loads in 'Loads' "
                      "alone have no state with Coulomb's friction. Look at "
                      "them with 'Analysis = state', or set 'Friction/Law = "
                      "associated Coulomb'.");
  // A factor that is not known well may have states beyond it.
  factor.carried = states.find_greatest(factor.has_mechanism() &&
                                                factor.width() > smallest_width
                                            ? factor.bound
                                            : factor.carried);
  factor.trials = states.trials();
  factor.passes = states.found->passes;
  factor.n_iterations += states.n_iterations;
  factor.forces = dimensional_forces(states.problem, *states.found);
  return answer;
}
} // namespace Voussoir
