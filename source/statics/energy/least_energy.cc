// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/statics/energy/elastic_problem.h>
#include <voussoir/statics/energy/energy_program.h>
#include <voussoir/statics/energy/least_energy.h>
#include <voussoir/statics/energy/yielding_joints.h>
#include <voussoir/statics/problem/discretise.h>

#include <deal.II/base/timer.h>

#include <utility>
#include <vector>

namespace Voussoir
{
namespace
{
/** Minimise by all processes; @p whole and @p order are the root's. */
Solution minimise_together(const DiscreteProblem *whole,
                           const ElasticOrder &order,
                           const std::vector<double> &start,
                           const ProcessGroup &processes,
                           Terminal &terminal)
{
  return processes.together([&]() {
    const ElasticOrder of_root = processes.broadcast(order);
    const dealii::Timer timer;
    const SharedProblem problem(whole, processes);
    const double seconds_to_share = timer.wall_time();
    Solution solution = minimise_elastic(problem, of_root, start, terminal);
    if (processes.size() > 1)
      solution.seconds["sharing"] = seconds_to_share;
    return solution;
  });
}
} // namespace

void LeastEnergy::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter("Modulus", modulus,
                    "Of the elastic joints, whose stiffness is the modulus "
                    "times |e| / d_e. It divides the displacements in the "
                    "results and changes nothing else; a stress.",
                    Double(1e-100, 1e100));
  add_linear_solver(prm, linear_solver);
}

Solution LeastEnergy::select(const DiscreteProblem &problem,
                             const SolverControls &controls,
                             Terminal &terminal) const
{
  const ElasticOrder order = {linear_solver, controls.tolerance,
                              controls.n_max_iterations};
  std::vector<double> start;
  if (controls.start) // whose loads, and with them the units, may be others
    start = nondimensional_motion(problem,
                                  dimensional_motion(problem, *controls.start),
                                  displacement_unit(problem));
  if (!problem.normal_limits().empty())
    return minimise_yielding(problem, order, std::move(start), terminal);
  const ProcessGroup processes =
      SharedProblem::helpers(problem, controls.processes);
  processes.call(least_energy_task);
  if (processes.size() > 1)
    start.clear();
  const Solution solution =
      minimise_together(&problem, order, start, processes, terminal);
  return second_attempt(problem, elastic_costs(problem), controls, solution,
                        terminal);
}

void work_on_least_energy(const ProcessGroup &processes, Terminal &terminal)
{
  minimise_together(nullptr, {}, {}, processes, terminal);
}
} // namespace Voussoir
