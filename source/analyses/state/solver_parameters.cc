// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/state/solver_parameters.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/statics/energy/least_energy.h>
#include <voussoir/statics/paper/analytic_centre.h>
#include <voussoir/statics/paper/linear_program.h>
#include <voussoir/statics/paper/smoothed_friction.h>

namespace Voussoir
{
namespace
{
/** The one place where a formulation is registered. */
std::vector<std::unique_ptr<Formulation>> all_formulations()
{
  std::vector<std::unique_ptr<Formulation>> all;
  all.push_back(std::make_unique<SmoothedFriction>());
  all.push_back(std::make_unique<LinearProgram>());
  all.push_back(std::make_unique<AnalyticCentre>());
  all.push_back(std::make_unique<LeastEnergy>());
  return all;
}
} // namespace

SolverParameters::SolverParameters(const ProcessGroup &processes)
    : formulations(all_formulations()), coulomb_state(*formulations.back())
{
  common.processes = processes;
}

const Formulation &SolverParameters::formulation_for(const Scene &scene) const
{
  if (!scene.dilates)
    return coulomb_state;
  return scene.coefficient.empty() && !scene.has_more_than_friction()
             ? formulation()
             : any_state;
}

void SolverParameters::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  std::vector<Choice<unsigned int>> choices;
  for (unsigned int i = 0; i < formulations.size(); ++i)
    choices.push_back({i, formulations[i]->name(), formulations[i]->meaning(),
                       "Solver/" + formulations[i]->name()});
  add_choice(prm, "Formulation", chosen, choices,
             "How one of the many admissible and balanced states is selected.");

  prm.enter_subsection("Solver");
  prm.add_parameter("Tolerance", common.tolerance,
                    "The largest force imbalance of a cell to stop at, as a "
                    "fraction of the sum of the sizes of all loads over the "
                    "square root of the number of cells. Hard contact stops at "
                    "a hundredth of its 'Barrier parameter', if that is less.",
                    Double(1e-14, 1e-2));
  prm.add_parameter("Tolerance of the load factor", common.tolerance_of_factor,
                    "The largest distance of the two bounds of a load factor "
                    "to stop at, over the larger of them.",
                    Double(1e-15, 1.));
  prm.add_parameter("Maximum iterations", common.n_max_iterations,
                    "Give up after so many iterations. A search for a proof of "
                    "collapse that follows has as many of its own.",
                    Integer(1, 1000000));
  prm.add_parameter("Equilibrate", common.equilibrate,
                    "Whether the forces are then corrected, as little as "
                    "possible, until every cell balances to rounding. It costs "
                    "as much as a few iterations of Newton's method.",
                    Bool());
  for (const auto &formulation : formulations)
  {
    prm.enter_subsection(formulation->name());
    formulation->add_parameters(prm);
    prm.leave_subsection();
  }
  prm.leave_subsection();
}
} // namespace Voussoir
