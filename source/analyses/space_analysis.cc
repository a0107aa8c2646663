// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/factor_without_dilatancy.h>
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/analyses/space/ranges.h>
#include <voussoir/analyses/space/settlement.h>
#include <voussoir/analyses/space_analysis.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/problem/discretise_space.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/** Two sets of loads together, the second one times @p factor. */
SpaceLoads sum_of(const SpaceLoads &a, const double factor, const SpaceLoads &b)
{
  SpaceLoads sum = a;
  sum.add(factor, b);
  return sum;
}

void show_loads(Terminal &terminal,
                const SpaceScene &scene,
                const std::string &name)
{
  dealii::Tensor<1, 3> sum;
  double size = 0.;
  unsigned int n_loaded = 0;
  for (unsigned int c = 0; c < scene.packing().n_cells(); ++c)
  {
    sum += scene.loads.force[c];
    size += scene.loads.size[c];
    n_loaded += scene.loads.size[c] > 0.;
  }
  terminal.stage(name, text("on ", counted(n_loaded, "cell"), ", in all (",
                            sum[0], ", ", sum[1], ", ", sum[2],
                            "), of forces of the size ", size));
}

/** Judge the forces at a factor, and say what it is. */
void keep_factor(SpaceAnswer &answer,
                 FactorOf<SpaceScene> found,
                 const FactorEntries::Factor multiplied,
                 Terminal &terminal)
{
  answer.sentence = sentence_of(found, multiplied);
  if (answer.sentence.empty())
    answer.sentence = "Load factor: " + description_of(found) + '.';
  answer.summary["load_factor"] = json_of(found);
  answer.summary["solver"] = {{"iterations", found.n_iterations}};
  terminal.stage("Load factor", description_of(found));
  answer.forces = std::move(found.forces);
  answer.motion = std::move(found.mechanism);
  answer.is_mechanism = !answer.motion.displacement.empty();
  judge_forces(answer);
}
} // namespace

void SpaceAnalysis::add_entries(dealii::ParameterHandler &prm)
{
  add_choice<Question>(
      prm, "Analysis", question,
      {{Question::state, "state",
        "forces that carry the loads, those of least energy, or the mechanism "
        "in which they collapse; without loads nothing.",
        "Ranges"},
       {Question::load_factor, "load factor",
        "the greatest factor of loads that is carried, between two proofs.",
        "Live loads, Load factor"}},
      "What is asked of the packing.");
  add_choice<Selection>(
      prm, "Formulation", selection,
      {{Selection::least_energy, least_energy.name(),
        least_energy.meaning() + " For all laws."},
       {Selection::smoothed_friction, smoothed_friction.name(),
        smoothed_friction.meaning()}},
      "How one of the many admissible and balanced states is selected. The "
      "formulations 'linear program' and 'analytic centre' are for packings in "
      "the plane.");
  prm.add_parameter(
      "Clamping", finds_clamping,
      "Whether to find out besides if the packing is clamped: if a motion "
      "opens every contact, or else which normal forces balance by themselves, "
      "without loads. Supports and shapes decide it alone.",
      dealii::Patterns::Bool());
}

const Formulation &SpaceAnalysis::formulation_for(const SpaceScene &scene) const
{
  const Strengths &strengths = scene.blocks->strengths;
  if (!strengths.dilate)
    return coulomb_state;
  const bool has_bounds_alone = strengths.coefficient.empty() &&
                                strengths.tensile.empty() &&
                                strengths.compressive.empty();
  if (selection == Selection::smoothed_friction && has_bounds_alone)
    return smoothed_friction;
  return least_energy;
}

void SpaceAnalysis::add_sections(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  factor.add_parameters(prm);
  ranges.add_parameters<3>(prm);
  prm.enter_subsection("Solver");
  prm.add_parameter("Tolerance", controls.tolerance,
                    "The largest force imbalance of a cell to stop at, as a "
                    "fraction of the sum of the sizes of all loads over the "
                    "square root of the number of cells.",
                    Double(1e-14, 1e-2));
  prm.add_parameter("Tolerance of the load factor",
                    controls.tolerance_of_factor,
                    "The largest distance of the two bounds of a load factor "
                    "to stop at, over the larger of them.",
                    Double(1e-15, 1.));
  prm.add_parameter("Maximum iterations", controls.n_max_iterations,
                    "Give up after so many iterations.", Integer(1, 1000000));
  add_linear_solver(prm, least_energy.linear_solver);
  prm.leave_subsection();
}

SpaceAnalysis::Scenes
SpaceAnalysis::scenes(const SpaceSceneParameters &parameters,
                      const std::shared_ptr<const SpaceBlocks> &blocks,
                      Terminal &terminal) const
{
  Scenes found = {parameters.scene_of(blocks, terminal), {}};
  if (question == Question::state)
    check_further(parameters, blocks->packing);
  if (found.dead.is_loaded())
    show_loads(terminal, found.dead, "Loads");
  if (question == Question::load_factor)
  {
    found.live = parameters.live_scene_of(blocks, terminal);
    if (found.live->is_loaded())
      show_loads(terminal, *found.live, "Live loads");
  }
  return found;
}

void SpaceAnalysis::check_further(const SpaceSceneParameters &parameters,
                                  const Packing<3> &packing) const
{
  parameters.motion_of_supports(packing);
  ranges.wanted(packing);
}

SpaceAnswer
SpaceAnalysis::answer(const SpaceSceneParameters &parameters,
                      const std::shared_ptr<const SpaceBlocks> &blocks,
                      Terminal &terminal) const
{
  Scenes on_loads = scenes(parameters, blocks, terminal);
  std::optional<Clamping> clamping;
  if (finds_clamping)
    clamping = find_clamping(*blocks, terminal);
  SpaceAnswer found = answer_on(std::move(on_loads), parameters, terminal);
  found.clamping = std::move(clamping);
  return found;
}

SpaceAnswer SpaceAnalysis::answer_on(Scenes scenes,
                                     const SpaceSceneParameters &parameters,
                                     Terminal &terminal) const
{
  auto &[dead, live] = scenes;
  if (!live)
  {
    SpaceAnswer state = state_of(std::move(dead), terminal);
    if (state.is_carried())
      look_further(state, parameters, terminal);
    return state;
  }
  if (factor.multiplied == FactorEntries::Factor::strength)
  {
    dead.loads = sum_of(dead.loads, 1., live->loads);
    return strength_factor_of(std::move(dead), terminal);
  }
  if (factor.multiplied == FactorEntries::Factor::all_loads)
  {
    live->loads = sum_of(dead.loads, 1., live->loads);
    dead.loads = SpaceLoads(dead.packing().n_cells());
  }
  return factor_of(std::move(dead), std::move(*live), terminal);
}

SpaceAnswer SpaceAnalysis::state_of(SpaceScene scene, Terminal &terminal) const
{
  SpaceAnswer answer = {std::move(scene)};
  if (!answer.scene.is_loaded())
    return answer;
  answer.is_analysed = true;
  terminal.begin("Statics");
  const DiscreteProblem problem = discretise(answer.scene);
  const Formulation &formulation = formulation_for(answer.scene);
  const Solution solution = formulation.solve(problem, controls, terminal);
  if (solution.mechanism)
  {
    answer.motion =
        dimensional_motion(problem, answer.scene, solution.mechanism->u, 1.);
    judge_mechanism(answer, "The load is not carried: the packing collapses");
  }
  else
  {
    answer.forces = dimensional_forces(problem, answer.scene, solution);
    answer.motion =
        dimensional_motion(problem, answer.scene, solution.u,
                           problem.stress_scale() * problem.length_scale());
    judge_forces(answer);
  }
  answer.summary = {{"formulation", formulation.name()},
                    {"selection", solution.selection.empty()
                                      ? formulation.selection()
                                      : solution.selection},
                    {"solver", {{"iterations", solution.n_iterations}}}};
  if (solution.passes.n > 0)
    answer.summary["solver"]["passes"] = {{"number", solution.passes.n},
                                          {"rate", solution.passes.rate}};
  terminal.stage("Statics", text(answer.status.description(), " after ",
                                 counted(solution.n_iterations, "iteration")));
  return answer;
}

/** The settlement, and the ranges of forces, of what is carried. */
void SpaceAnalysis::look_further(SpaceAnswer &answer,
                                 const SpaceSceneParameters &parameters,
                                 Terminal &terminal) const
{
  const Packing<3> &packing = answer.scene.packing();
  if (const auto of_supports = parameters.motion_of_supports(packing);
      !of_supports.empty())
    settle(answer, of_supports, terminal);
  if (const auto wanted = ranges.wanted(packing))
    add_ranges(answer, *wanted, terminal);
}

SpaceAnswer SpaceAnalysis::factor_of(SpaceScene dead,
                                     SpaceScene live,
                                     Terminal &terminal) const
{
  terminal.begin("Load factor");
  FactorAnswerOf<SpaceScene> found =
      dead.blocks->strengths.dilate
          ? find_load_factor(dead, live, factor.controls(controls), terminal)
          : find_factor_without_dilatancy(dead, live, coulomb_state, controls,
                                          factor.controls(controls), terminal);
  SpaceAnswer answer = {dead};
  answer.is_analysed = true;
  if (!found.factor)
  {
    answer.motion = std::move(found.collapse);
    judge_mechanism(answer,
                    found.collapses_with_any
                        ? "The dead loads are not carried, with any factor of "
                          "the live loads: the packing collapses"
                        : "The dead loads are not carried, and no factor of "
                          "the live loads is known that helps: the packing "
                          "collapses");
    terminal.stage("Load factor", answer.status.description());
    return answer;
  }
  answer.scene.loads = sum_of(dead.loads, found.factor->carried, live.loads);
  keep_factor(answer, std::move(*found.factor), factor.multiplied, terminal);
  // Only what does not depend on the pressure is cut into cells.
  const auto &strength = dead.blocks->strengths.of_interface;
  if (answer.is_mechanism && dead.blocks->turns() &&
      dead.blocks->strengths.dilate &&
      std::any_of(strength.begin(), strength.end(),
                  [](const double s) { return s > 0.; }))
    answer.summary["load_factor"]["bound_of_continuous_faces"] =
        bound_of_continuous_faces(dead, live, answer.motion).factor;
  answer.live = std::move(live.loads);
  return answer;
}

SpaceAnswer SpaceAnalysis::strength_factor_of(SpaceScene scene,
                                              Terminal &terminal) const
{
  check_strength_factor(scene, factor.controls(controls));
  terminal.begin("Load factor");
  FactorAnswerOf<SpaceScene> found =
      find_strength_factor(scene, factor.controls(controls), terminal);
  SpaceAnswer answer = {std::move(scene)};
  answer.is_analysed = true;
  if (!found.factor)
  {
    answer.motion = std::move(found.collapse);
    judge_mechanism(answer, "The load is not carried with any strengths: the "
                            "packing collapses");
    terminal.stage("Load factor", answer.status.description());
    return answer;
  }
  if (!found.factor->is_unbounded)
    answer.scene = with_strengths_divided(answer.scene, found.factor->carried);
  keep_factor(answer, std::move(*found.factor), factor.multiplied, terminal);
  return answer;
}
} // namespace Voussoir
