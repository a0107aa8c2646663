// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/settlement_analysis.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/proofs/displacement_jumps.h>

#include <cmath>
#include <utility>

namespace Voussoir
{
namespace
{
/** A jump, over the largest displacement of a support, that is one. */
constexpr double least_jump = 1e-6;

/** How many interfaces a settlement opens or lets slide. */
struct CountOfJumps
{
  CountOfJumps(const Scene &scene, const Settlement &settlement)
  {
    const InterfaceJumps jumps = jumps_of(scene.packing, settlement.motion);
    const double least = least_jump * settlement.largest_displacement;
    for (unsigned int e = 0; e < jumps.sliding.size(); ++e)
    {
      const bool at_start = jumps.openings[e][0] > least;
      const bool at_end = jumps.openings[e][1] > least;
      open += at_start && at_end;
      hinges += at_start != at_end;
      sliding += std::abs(jumps.sliding[e]) > least;
    }
  }

  unsigned int open = 0;    /**< all along */
  unsigned int hinges = 0;  /**< at one end only */
  unsigned int sliding = 0; /**< along themselves */
};

nlohmann::ordered_json summary_of(const Scene &scene,
                                  const Settlement &settlement)
{
  const CountOfJumps count(scene, settlement);
  return {{"largest_displacement", settlement.largest_displacement},
          {"work", settlement.work},
          {"width", settlement.width},
          {"closing_violation", settlement.closing_violation},
          {"hinges", count.hinges},
          {"open", count.open},
          {"sliding", count.sliding}};
}

std::string sentence_of(const Scene &scene, const Settlement &settlement)
{
  const CountOfJumps count(scene, settlement);
  std::ostringstream words;
  words.precision(4);
  words << "As the supports move by up to " << settlement.largest_displacement
        << "{L}, ";
  std::string joints;
  for (const auto &[n, what] : {std::pair(count.hinges, " about an end"),
                                std::pair(count.open, " all along"),
                                std::pair(count.sliding, " by sliding")})
    if (n > 0)
      joints += (joints.empty() ? "" : ", ") + std::to_string(n) + what;
  words << (joints.empty() ? "no joint gives way." : "joints give way: ")
        << joints << (joints.empty() ? "" : ".");
  return words.str();
}
} // namespace

std::string description_of(const Scene &scene, const Settlement &settlement)
{
  const CountOfJumps count(scene, settlement);
  return text("supports move by at most ", settlement.largest_displacement,
              "; interfaces with a hinge: ", count.hinges,
              ", open: ", count.open, ", sliding: ", count.sliding);
}

void SettlementAnalysis::answer(AnalysisOutcome &outcome,
                                const AnalysisContext &context) const
{
  const Scene &scene = *outcome.scene;
  const std::vector<SupportMotion> of_supports =
      context.parameters.motion_of_supports(scene.packing);
  if (of_supports.empty())
    return;
  context.timer.enter_subsection(name());
  context.terminal.begin("Settlement");
  Settlement found = find_settlement(scene, of_supports);
  SolverRecord &record = outcome.record;
  record.formulation = name();
  record.selection = "forces that go with the displacement of the supports";
  record.outcome = Stop(Stop::Reason::converged).words();
  record.passes = {};
  record.n_iterations = record.n_evaluations = found.n_iterations;
  context.terminal.stage("Settlement", counted(record.n_iterations, "step") +
                                           " of the simplex method");
  context.timer.leave_subsection();

  AnalysisResult result = {name(), "Settlement", description_of(scene, found),
                           summary_of(scene, found)};
  result.sentence = sentence_of(scene, found);
  result.motion = MotionBeside{found.motion, "Settlement", true};
  outcome.results.push_back(std::move(result));
  Carried state;
  state.forces = std::move(found.forces);
  state.motion = std::move(found.motion);
  outcome.answer = judge(scene, std::move(state), record,
                         context.solver.controls().tolerance, context.timer,
                         context.terminal);
}
} // namespace Voussoir
