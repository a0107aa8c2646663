// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_analyses_ranges_range_words_h
#define voussoir_analyses_ranges_range_words_h

#include <voussoir/analyses/ranges/ranges.h>

#include <nlohmann/json.hpp>

#include <string>

namespace Voussoir
{
// What is said of Ranges and of SpaceRanges.

/** How many interfaces have their ranges, and of which kinds they are. */
struct CountOfRanges
{
  /** Of Ranges or SpaceRanges. */
  template <typename RangesOf>
  explicit CountOfRanges(const RangesOf &ranges)
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

/**
 * A line for people on how many interfaces and supports have ranges.
 *
 * @param support what a support is called.
 */
template <typename RangesOf>
std::string words_of_ranges(const RangesOf &ranges, const std::string &support);

/**
 * The numbers, with the errors of the proofs over the loads.
 *
 * @param reactions the list of their ranges.
 */
template <typename RangesOf>
nlohmann::ordered_json json_of_ranges(const RangesOf &ranges,
                                      nlohmann::ordered_json reactions);

/** Both ends. */
nlohmann::ordered_json json_of_range(const Range &range);
} // namespace Voussoir

#endif
