// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/range_words.h>
#include <voussoir/analyses/space/ranges.h>
#include <voussoir/base/text.h>

namespace Voussoir
{
namespace
{
using Json = nlohmann::ordered_json;

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
} // namespace

void add_ranges(SpaceAnswer &answer,
                const RangesWanted &wanted,
                Terminal &terminal)
{
  terminal.begin("Ranges");
  SpaceRanges found = find_ranges(answer.scene, wanted, terminal);
  const std::string words = words_of_ranges(found, "support");
  terminal.stage(
      "Ranges",
      text(words, "; ", counted(found.proofs.n_programmes, "conic programme")));
  answer.lines.emplace_back("Ranges", words);
  answer.summary["ranges"] =
      json_of_ranges(found, json_of_reaction_ranges(found));
  answer.ranges = std::move(found);
}
} // namespace Voussoir
