// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/statics/conic/balance_within_limits.h>
#include <voussoir/statics/conic/feasible_state.h>
#include <voussoir/statics/problem/equilibrate.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/**
 * The distance from a limit, as in equilibrate(), that no change of strengths
 * uses up where they are nearly their own.
 */
constexpr double slack_beside_changes = 1e-3;
/** The shares of a state away from the limits that are tried, in turn. */
constexpr double shares_of_inner[] = {1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5};
/** The iterations to such a state; it takes about ten. */
constexpr unsigned int n_max_of_inner = 100;

/** In space. */
std::vector<double> balance_by_cones(const DiscreteProblem &problem,
                                     const std::vector<double> &forces,
                                     Terminal &terminal)
{
  RowProblem by_rows(problem);
  const std::optional<FactorState> inner =
      find_feasible_forces(by_rows, by_rows.loads(), n_max_of_inner, terminal)
          .state;
  if (!inner)
    return forces;
  const SelfDual::Program program = {by_rows.loads()};
  SelfDual::Point point;
  point.x = by_rows.rows().rows_of(forces);
  point.s = by_rows.forces().limits();
  add(point.s, -1., by_rows.forces().at_slacks(point.x));
  point.alpha = 0.;
  // Slacks of bounds have signs; cones are entered by the share.
  for (std::size_t b = 0; b < by_rows.forces().bounds().size(); ++b)
    point.s[b] = std::max(point.s[b], 0.);
  for (const double share : shares_of_inner)
  {
    const FactorState state =
        state_near(by_rows.forces(), program, point, inner, share);
    if (state.residual <= largest_residual_of_state)
      return by_rows.rows().forces_of(state.x);
  }
  return forces;
}
} // namespace

std::vector<double> balance_within_limits(const DiscreteProblem &problem,
                                          const std::vector<double> &forces,
                                          Terminal &terminal)
{
  return problem.is_plane() ? equilibrate(problem, forces, slack_beside_changes)
                            : balance_by_cones(problem, forces, terminal);
}
} // namespace Voussoir
