// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/factors/strength_factor.h>
#include <voussoir/analyses/space_analysis.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/base/text.h>
#include <voussoir/statics/energy/space_state.h>
#include <voussoir/statics/problem/discretise_space.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/** The largest error of forces that is rounding; see largest_accepted_error.
 * Displacements add up over the cells across a packing. */
double rounding_of_forces(const unsigned int n_cells)
{
  return std::max(1e-11, 100. * std::numeric_limits<double>::epsilon() *
                             std::sqrt(double(n_cells)));
}

/** Two sets of loads together, the second one times @p factor. */
SpaceLoads sum_of(const SpaceLoads &a, const double factor, const SpaceLoads &b)
{
  SpaceLoads sum = a;
  for (unsigned int c = 0; c < sum.size.size(); ++c)
  {
    sum.force[c] += factor * b.force[c];
    sum.torque[c] += factor * b.torque[c];
    sum.size[c] += std::abs(factor) * b.size[c];
  }
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

std::string words_of_error(const SpaceScene &scene, const LargestError &largest)
{
  const char *const what =
      largest.kind == LargestError::Kind::balance  ? "the balance of forces"
      : largest.kind == LargestError::Kind::moment ? "the balance of moments"
                                                   : "a limit of forces";
  return text(what, " at ", scene.packing().describe(largest.cell), " at ",
              text_of_point(scene.packing().centre(largest.cell)));
}

/**
 * Judge forces and fill in the status.
 *
 * @throws SolverError if their errors are too large.
 */
void judge_forces(SpaceAnswer &answer)
{
  answer.certificate = certify(answer.scene, answer.forces);
  const double error = answer.certificate.error();
  if (!(error <= largest_accepted_error))
    throw SolverError(
        text("The forces that were found are wrong by ", error,
             " of the largest load, in ",
             words_of_error(answer.scene, answer.certificate.largest),
             ". The load is close to what the packing can carry, or the sizes "
             "of blocks or strengths differ by too much; look whether other "
             "units or loads help."));
  if (error <= rounding_of_forces(answer.scene.packing().n_cells()))
    answer.status = {Status::Kind::solved, 0.};
  else
    answer.status = {Status::Kind::carried_within, error};
}

/**
 * Judge a mechanism and fill in the status.
 *
 * @throws SolverError if it proves nothing.
 */
void judge_mechanism(SpaceAnswer &answer, const std::string &what)
{
  answer.proof = certify_mechanism(answer.scene, answer.motion);
  if (!proves_collapse(answer.proof))
    throw SolverError(
        text("A mechanism was found that proves nothing: joints close by ",
             answer.proof.closing_violation,
             " of the displacement, and the loads do ",
             answer.proof.work_over_dissipation,
             " times the work that friction dissipates. The load is close to "
             "what the packing can carry."));
  answer.is_mechanism = true;
  answer.status = {Status::Kind::collapse, 0.};
  answer.message = text(what, " in a mechanism in which joints close by ",
                        answer.proof.closing_violation,
                        " of the displacement, and the loads do ",
                        std::isfinite(answer.proof.work_over_dissipation)
                            ? text(answer.proof.work_over_dissipation,
                                   " times the work that strengths dissipate.")
                            : "work that no strength dissipates.");
}

/** Judge the forces at a factor, and say what it is. */
void keep_factor(SpaceAnswer &answer,
                 FactorOf<SpaceScene> found,
                 Terminal &terminal)
{
  answer.summary["load_factor"] = json_of_proofs(found);
  answer.summary["load_factor"]["meaning"] = words_of_proofs(found);
  answer.summary["solver"] = {{"iterations", found.n_iterations}};
  terminal.stage("Load factor", words_of_proofs(found));
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
        "in which they collapse; without loads nothing."},
       {Question::load_factor, "load factor",
        "the greatest factor of loads that is carried, between two proofs.",
        "Live loads, Load factor"}},
      "What is asked of the packing.");
}

void SpaceAnalysis::add_sections(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  factor.add_parameters(prm);
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
  add_linear_solver(prm, linear_solver);
  prm.leave_subsection();
}

SpaceAnalysis::Scenes
SpaceAnalysis::scenes(const SpaceSceneParameters &parameters,
                      const std::shared_ptr<const SpaceBlocks> &blocks,
                      Terminal &terminal) const
{
  Scenes found = {parameters.scene_of(blocks, terminal), {}};
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

SpaceAnswer
SpaceAnalysis::answer(const SpaceSceneParameters &parameters,
                      const std::shared_ptr<const SpaceBlocks> &blocks,
                      Terminal &terminal) const
{
  auto [dead, live] = scenes(parameters, blocks, terminal);
  if (!live)
    return state_of(std::move(dead), terminal);
  if (factor.multiplied == FactorEntries::Factor::strength)
  {
    dead.loads = sum_of(dead.loads, 1., live->loads);
    return strength_factor_of(std::move(dead), terminal);
  }
  if (factor.multiplied == FactorEntries::Factor::all_loads)
  {
    live->loads = sum_of(dead.loads, 1., live->loads);
    dead.loads = SpaceLoads(blocks->packing.n_cells());
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
  const Solution solution =
      find_space_state(problem, controls, linear_solver, terminal);
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
  answer.summary = {
      {"formulation", "least energy"},
      {"selection", solution.selection.empty()
                        ? "the state of least energy of elastic joints"
                        : solution.selection},
      {"solver", {{"iterations", solution.n_iterations}}}};
  terminal.stage("Statics", text(answer.status.description(), " after ",
                                 counted(solution.n_iterations, "iteration")));
  return answer;
}

SpaceAnswer SpaceAnalysis::factor_of(SpaceScene dead,
                                     SpaceScene live,
                                     Terminal &terminal) const
{
  terminal.begin("Load factor");
  FactorAnswerOf<SpaceScene> found =
      find_load_factor(dead, live, factor.controls(controls), terminal);
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
  keep_factor(answer, std::move(*found.factor), terminal);
  // Only what does not depend on the pressure is cut into cells.
  const auto &strength = dead.blocks->strengths.of_interface;
  if (answer.is_mechanism && dead.blocks->turns() &&
      std::any_of(strength.begin(), strength.end(),
                  [](const double s) { return s > 0.; }))
    answer.summary["load_factor"]["bound_of_continuous_faces"] =
        bound_of_continuous_faces(dead, live, answer.motion).factor;
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
  keep_factor(answer, std::move(*found.factor), terminal);
  return answer;
}
} // namespace Voussoir
