// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factor_outcome.h>
#include <voussoir/base/exceptions.h>

#include <memory>
#include <utility>

namespace Voussoir
{
AnalysisOutcome outcome_of(FactorSearch &found,
                           SolverRecord record,
                           const std::string &stage,
                           const bool has_dead_loads,
                           const AnalysisContext &context)
{
  AnalysisOutcome outcome;
  outcome.scene = std::make_unique<const Scene>(std::move(found.scene));
  const Scene &scene = *outcome.scene;
  context.show_loads(scene);
  if (!found.answer.factor)
  {
    NotCarried collapse = prove(scene, std::move(found.answer.collapse));
    if (has_dead_loads)
      collapse.loads = found.answer.collapses_with_any
                           ? NotCarried::Loads::dead_beside_any
                           : NotCarried::Loads::dead;
    outcome.answer = std::move(collapse);
    return outcome;
  }
  outcome.record = std::move(record);
  context.terminal.stage("Statics", stage);
  // Cells do not move under forces at a factor.
  Carried state;
  state.forces = std::move(found.answer.factor->forces);
  state.motion = Motion(scene.packing.n_cells(), *scene.kinematics);
  outcome.answer = judge(scene, std::move(state), outcome.record,
                         context.solver.controls().tolerance, context.timer,
                         context.terminal);
  if (!std::holds_alternative<Carried>(outcome.answer))
    throw SolverError("The state found at the load factor does not carry its "
                      "loads; loosen 'Solver/Tolerance of the load factor'.");
  return outcome;
}

std::optional<MotionBeside> mechanism_of(FactorSearch &found)
{
  LoadFactor &factor = *found.answer.factor;
  if (!factor.has_mechanism())
    return {};
  return MotionBeside{std::move(factor.mechanism), "Mechanism", false,
                      std::move(found.live)};
}
} // namespace Voussoir
