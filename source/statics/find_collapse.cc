// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/barrier_problem.h>
#include <voussoir/statics/elastic_problem.h>
#include <voussoir/statics/find_collapse.h>

namespace Voussoir
{
std::optional<Mechanism> find_collapse(const SharedProblem &problem,
                                       Terminal &terminal)
{
  return problem.has_opening() ? find_collapse_by_barrier(problem, terminal)
                               : find_collapse_by_springs(problem, terminal);
}
} // namespace Voussoir
