// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/range_words.h>
#include <voussoir/analyses/ranges/space_ranges.h>
#include <voussoir/base/text.h>

#include <utility>

namespace Voussoir
{
template <typename RangesOf>
std::string words_of_ranges(const RangesOf &ranges, const std::string &support)
{
  const CountOfRanges count(ranges);
  std::string words = text("forces of ", counted(count.wanted, "interface"),
                           ": ", count.determined, " determined by statics");
  if (count.unbounded > 0)
    words += text(", ", count.unbounded, " without bound");
  if (!ranges.reactions.empty())
    words += text("; reactions of ", counted(ranges.reactions.size(), support));
  return words;
}

template <typename RangesOf>
nlohmann::ordered_json json_of_ranges(const RangesOf &ranges,
                                      nlohmann::ordered_json reactions)
{
  const CountOfRanges count(ranges);
  return {{"interfaces", count.wanted},
          {"determined", count.determined},
          {"unbounded", count.unbounded},
          {"reactions", std::move(reactions)},
          {"width",
           ranges.reference > 0.
               ? nlohmann::ordered_json(ranges.proofs.width / ranges.reference)
               : nlohmann::ordered_json(nullptr)},
          {"error_of_states", ranges.proofs.error_of_states},
          {"closing_violation", ranges.proofs.closing_violation},
          {"programmes", ranges.proofs.n_programmes}};
}

nlohmann::ordered_json json_of_range(const Range &range)
{
  return nlohmann::ordered_json::array({range.least, range.greatest});
}

template std::string words_of_ranges(const Ranges &, const std::string &);
template std::string words_of_ranges(const SpaceRanges &, const std::string &);
template nlohmann::ordered_json json_of_ranges(const Ranges &,
                                               nlohmann::ordered_json);
template nlohmann::ordered_json json_of_ranges(const SpaceRanges &,
                                               nlohmann::ordered_json);
} // namespace Voussoir
