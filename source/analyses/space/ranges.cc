// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/space/ranges.h>
#include <voussoir/base/text.h>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

/** How many interfaces have their ranges, and of which kinds they are. */
struct CountOfSpaceRanges
{
  explicit CountOfSpaceRanges(const SpaceRanges &ranges)
  {
    for (unsigned int e = 0; e < ranges.wanted.size(); ++e)
    {
      wanted += ranges.wanted[e];
      determined += ranges.is_determined(e);
      unbounded += ranges.is_unbounded(e);
    }
  }

  unsigned int wanted = 0;     /**< that were asked for */
  unsigned int determined = 0; /**< with the same force in all states */
  unsigned int unbounded = 0;  /**< with a force of any size */
};

std::string words_of_ranges(const SpaceRanges &ranges)
{
  const CountOfSpaceRanges count(ranges);
  std::string words = text("forces of ", counted(count.wanted, "interface"),
                           ": ", count.determined, " determined by statics");
  if (count.unbounded > 0)
    words += text(", ", count.unbounded, " without bound");
  if (!ranges.reactions.empty())
    words +=
        text("; reactions of ", counted(ranges.reactions.size(), "support"));
  return words;
}

Json json_of_range(const Range &range)
{
  return Json::array({range.least, range.greatest});
}

Json json_of_reaction_ranges(const SpaceRanges &ranges)
{
  Json json = Json::array();
  for (unsigned int s = 0; s < ranges.reactions.size(); ++s)
  {
    const PlaneSupport &support = ranges.supports[s];
    const RangeOfVector &of = ranges.reactions[s];
    json.push_back(
        {{"centroid",
          {support.centroid[0], support.centroid[1], support.centroid[2]}},
         {"x", json_of_range(of[0])},
         {"y", json_of_range(of[1])},
         {"z", json_of_range(of[2])}});
  }
  return json;
}

Json json_of_ranges(const SpaceRanges &ranges)
{
  const CountOfSpaceRanges count(ranges);
  return {{"interfaces", count.wanted},
          {"determined", count.determined},
          {"unbounded", count.unbounded},
          {"reactions", json_of_reaction_ranges(ranges)},
          {"width", ranges.reference > 0.
                        ? Json(ranges.proofs.width / ranges.reference)
                        : Json(nullptr)},
          {"error_of_states", ranges.proofs.error_of_states},
          {"closing_violation", ranges.proofs.closing_violation},
          {"programmes", ranges.proofs.n_programmes}};
}
} // namespace

void add_ranges(SpaceAnswer &answer,
                const RangesWanted &wanted,
                Terminal &terminal)
{
  terminal.begin("Ranges");
  SpaceRanges found = find_ranges(answer.scene, wanted, terminal);
  const std::string words = words_of_ranges(found);
  terminal.stage(
      "Ranges",
      text(words, "; ", counted(found.proofs.n_programmes, "conic programme")));
  answer.lines.emplace_back("Ranges", words);
  answer.summary["ranges"] = json_of_ranges(found);
  answer.ranges = std::move(found);
}
} // namespace Voussoir
