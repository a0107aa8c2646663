// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/problem/sufficient_strengths.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
/** In units of stress. */
constexpr double first_sufficient_strength = 100.;
/** Of a mechanism, over the work of the loads. */
constexpr double largest_dissipation = 0.5;

/** The joints whose strength is lower in @p limited. */
std::vector<unsigned int> lowered_joints(const DiscreteProblem &problem,
                                         const DiscreteProblem &limited)
{
  std::vector<unsigned int> lowered;
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    if (limited.joints()[e].strength < problem.joints()[e].strength)
      lowered.push_back(e);
  return lowered;
}

bool any_slides(const std::vector<unsigned int> &joints, const Solution &found)
{
  if (!found.always_sliding.empty())
    for (const unsigned int e : joints)
      if (found.always_sliding[e])
        return true;
  return false;
}
} // namespace

bool collapses_with(const DiscreteProblem &problem, Solution &found)
{
  if (!found.mechanism || !problem.is_plane())
    return false;
  Mechanism mechanism = *found.mechanism;
  mechanism.work = problem.work(mechanism.u.data());
  mechanism.dissipation = dissipation_of(problem, mechanism.u.data());
  if (!(mechanism.dissipation < largest_dissipation * mechanism.work))
    return false;
  found.mechanism = std::move(mechanism);
  return true;
}

Solution solve_with_sufficient_strengths(
    const DiscreteProblem &problem,
    const SolverControls &controls,
    const std::function<Solution(const DiscreteProblem &,
                                 const SolverControls &)> &solve)
{
  const DiscreteProblem limited =
      problem.with_strengths_up_to(first_sufficient_strength);
  const std::vector<unsigned int> lowered = lowered_joints(problem, limited);
  Solution found = solve(limited, controls);
  if (lowered.empty() || (found.converged() && !any_slides(lowered, found)) ||
      collapses_with(problem, found))
    return found;

  SolverControls rest = controls;
  rest.n_max_iterations -=
      std::min(found.n_iterations, controls.n_max_iterations);
  Solution second = solve(problem, rest);
  const unsigned int n_iterations = found.n_iterations + second.n_iterations;
  const unsigned int n_evaluations = found.n_evaluations + second.n_evaluations;
  // Other proofs with lowered strengths prove nothing about the given ones.
  const bool first_is_better =
      !second.converged() && !second.mechanism && !found.mechanism;
  Solution &best = first_is_better ? found : second;
  best.n_iterations = n_iterations;
  best.n_evaluations = n_evaluations;
  return best;
}
} // namespace Voussoir
