// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/range_analysis.h>
#include <voussoir/analyses/ranges/range_words.h>
#include <voussoir/base/text.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** The most supports, and links, whose ranges are told in words. */
constexpr std::size_t most_in_words = 6;

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

/** The ranges of the forces of links. */
Json summary_of_links(const Ranges &ranges, const Scene &scene)
{
  Json json = Json::array();
  for (unsigned int k = 0; k < ranges.links.size(); ++k)
    json.push_back(
        {{"name", scene.links[k].name},
         {"at", {scene.links[k].on_minus[0], scene.links[k].on_minus[1]}},
         {"force", json_of_range(ranges.links[k])}});
  return json;
}

/** The ranges of forces. */
Json summary_of(const Ranges &ranges, const Scene &scene)
{
  Json json = json_of_ranges(ranges, summary_of_reactions(ranges));
  if (!ranges.links.empty())
    json["links"] = summary_of_links(ranges, scene);
  json["iterations"] = ranges.proofs.n_iterations;
  return json;
}

/** The largest distance of the ends of any range that is no interface's. */
double widest_beside_interfaces(const Ranges &ranges)
{
  double widest = 0.;
  const auto see = [&](const Range &range) {
    widest = std::max(widest, range.greatest - range.least);
  };
  for (const auto &reaction : ranges.reactions)
    for (const Range &range : reaction)
      see(range);
  for (const Range &range : ranges.links)
    see(range);
  return widest;
}

std::string sentence_of(const Ranges &ranges)
{
  std::ostringstream words;
  words.precision(4);
  words << "Among the states that carry the loads ";
  if (ranges.has_interfaces())
  {
    const CountOfRanges count(ranges);
    words << "the forces of " << count.determined << " of "
          << counted(count.wanted, "joint") << " are the same in all";
    if (count.unbounded > 0)
      words << ", and those of " << count.unbounded << " have no bound";
    words << '.';
    return words.str();
  }
  if (ranges.reactions.empty() && ranges.links.empty())
    return {};
  const double widest = widest_beside_interfaces(ranges);
  words << (ranges.links.empty()       ? "reactions"
            : ranges.reactions.empty() ? "the forces of ties"
                                       : "reactions and the forces of ties");
  if (!std::isfinite(widest))
    words << " differ without bound.";
  else if (widest <= Ranges::least_range * ranges.reference)
    words << " are the same.";
  else
    words << " differ by up to " << widest << "{F}.";
  return words.str();
}
} // namespace

std::string description_of(const Ranges &ranges, const Scene &scene)
{
  std::string words = words_of_ranges(ranges, "straight support");
  if (!ranges.links.empty())
    words += text("; forces of ", counted(ranges.links.size(), "link"));
  const auto shown = [&](const double force) {
    return std::abs(force) <= Ranges::least_range * ranges.reference ? 0.
                                                                     : force;
  };
  const auto from_to = [&](const Range &range) {
    return !range.is_bounded() ? std::string("without bound")
           : ranges.is_determined(range)
               ? text(shown(range.least))
               : text(shown(range.least), " to ", shown(range.greatest));
  };
  for (unsigned int s = 0;
       s < std::min<std::size_t>(ranges.reactions.size(), most_in_words); ++s)
    words += text("; from ", text_of_point(ranges.supports[s].start), " to ",
                  text_of_point(ranges.supports[s].end), " x ",
                  from_to(ranges.reactions[s][0]), ", y ",
                  from_to(ranges.reactions[s][1]));
  for (unsigned int k = 0;
       k < std::min<std::size_t>(ranges.links.size(), most_in_words); ++k)
    words += text("; ", scene.links[k].name, ' ', from_to(ranges.links[k]));
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
  AnalysisResult result = {name(), "Ranges", description_of(found, scene),
                           summary_of(found, scene)};
  result.sentence = sentence_of(found);
  result.data = std::move(found);
  outcome.results.push_back(std::move(result));
}
} // namespace Voussoir
