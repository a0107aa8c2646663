// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/energy/barrier_problem.h>
#include <voussoir/statics/energy/elastic_problem.h>
#include <voussoir/statics/energy/find_collapse.h>

namespace Voussoir
{
std::optional<Mechanism> find_collapse(const SharedProblem &problem,
                                       Terminal &terminal)
{
  if (problem.has_opening())
    return find_collapse_by_barrier(problem, terminal);
  try
  {
    return minimise_elastic(problem, {}, {}, terminal).mechanism;
  }
  catch (const SolverError &)
  {
    return {};
  }
}
} // namespace Voussoir
