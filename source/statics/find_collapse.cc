// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/statics/analytic_centre.h>
#include <voussoir/statics/find_collapse.h>
#include <voussoir/statics/least_energy.h>

namespace Voussoir
{
std::optional<Mechanism> find_collapse(const SharedProblem &problem,
                                       Terminal &terminal)
{
  try
  {
    return problem.has_opening() ? find_collapse_by_barrier(problem, terminal)
                                 : find_collapse_by_springs(problem, terminal);
  }
  catch (const SolverError &)
  {
    return {}; // whoever asked goes on without a proof
  }
}
} // namespace Voussoir
