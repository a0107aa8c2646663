// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/range_analysis.h>
#include <voussoir/base/text.h>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** How many interfaces have their ranges, and of which kinds they are. */
struct CountOfRanges
{
  explicit CountOfRanges(const Ranges &ranges)
  {
    for (unsigned int e = 0; e < ranges.wanted.size(); ++e)
    {
      wanted += ranges.wanted[e];
      determined += ranges.is_determined(e);
      unbounded += ranges.is_unbounded(e);
    }
  }

  unsigned int wanted = 0;     /**< that were asked for */
  unsigned int determined = 0; /**< with the same forces in all states */
  unsigned int unbounded = 0;  /**< with forces of any size */
};

/** The ranges of the reactions of all straight supports. */
Json summary_of_reactions(const Ranges &ranges)
{
  const auto pair = [](const Range &range) {
    return Json::array({range.least, range.greatest});
  };
  Json json = Json::array();
  for (unsigned int s = 0; s < ranges.reactions.size(); ++s)
  {
    const auto &[start, end, edges] = ranges.supports[s];
    const auto &[x, y] = ranges.reactions[s];
    json.push_back({{"from", {start[0], start[1]}},
                    {"to", {end[0], end[1]}},
                    {"x", pair(x)},
                    {"y", pair(y)}});
  }
  return json;
}

/** The ranges of forces, with the errors of their proofs over the loads. */
Json summary_of(const Ranges &ranges)
{
  const CountOfRanges count(ranges);
  return {{"interfaces", count.wanted},
          {"determined", count.determined},
          {"unbounded", count.unbounded},
          {"reactions", summary_of_reactions(ranges)},
          {"width", ranges.reference > 0.
                        ? Json(ranges.proofs.width / ranges.reference)
                        : Json(nullptr)},
          {"error_of_states", ranges.proofs.error_of_states},
          {"closing_violation", ranges.proofs.closing_violation},
          {"programmes", ranges.proofs.n_programmes},
          {"iterations", ranges.proofs.n_iterations}};
}
} // namespace

std::string description_of(const Ranges &ranges)
{
  const CountOfRanges count(ranges);
  std::string words = text("forces of ", counted(count.wanted, "interface"),
                           ": ", count.determined, " determined by statics");
  if (count.unbounded > 0)
    words += text(", ", count.unbounded, " without bound");
  if (!ranges.reactions.empty())
    words += text("; reactions of ",
                  counted(ranges.reactions.size(), "straight support"));
  return words;
}

void RangeAnalysis::check(const Scene &scene) const
{
  entries.wanted(scene.packing);
}

void RangeAnalysis::answer(AnalysisOutcome &outcome,
                           const AnalysisContext &context) const
{
  const Scene &scene = *outcome.scene;
  const std::optional<RangesWanted> of = entries.wanted(scene.packing);
  if (!of)
    return;
  const dealii::TimerOutput::Scope section(context.timer, name());
  context.terminal.begin("Ranges");
  Ranges found = find_ranges(scene, *of, context.terminal);
  context.terminal.stage(
      "Ranges", text(counted(found.proofs.n_programmes, "linear programme"),
                     ", ", counted(found.proofs.n_iterations, "step")));
  AnalysisResult result = {name(), "Ranges", description_of(found),
                           summary_of(found)};
  result.data = std::move(found);
  outcome.results.push_back(std::move(result));
}
} // namespace Voussoir
