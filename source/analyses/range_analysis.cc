// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/range_analysis.h>
#include <voussoir/analyses/ranges/range_words.h>
#include <voussoir/base/text.h>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** The ranges of the reactions of all straight supports. */
Json summary_of_reactions(const Ranges &ranges)
{
  Json json = Json::array();
  for (unsigned int s = 0; s < ranges.reactions.size(); ++s)
  {
    const auto &[start, end, edges] = ranges.supports[s];
    const auto &[x, y] = ranges.reactions[s];
    json.push_back({{"from", {start[0], start[1]}},
                    {"to", {end[0], end[1]}},
                    {"x", json_of_range(x)},
                    {"y", json_of_range(y)}});
  }
  return json;
}

/** The ranges of forces. */
Json summary_of(const Ranges &ranges)
{
  Json json = json_of_ranges(ranges, summary_of_reactions(ranges));
  json["iterations"] = ranges.proofs.n_iterations;
  return json;
}
} // namespace

std::string description_of(const Ranges &ranges)
{
  return words_of_ranges(ranges, "straight support");
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
