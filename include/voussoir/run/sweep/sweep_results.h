// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_run_sweep_sweep_results_h
#define voussoir_run_sweep_sweep_results_h

#include <nlohmann/json.hpp>

#include <optional>
#include <set>
#include <string>

namespace Voussoir
{
/** True if a summary has @p result, as in "ground/reaction/1". */
bool has_result(const nlohmann::ordered_json &summary,
                const std::string &result);

/** What a summary has there, as a text; empty if nothing, or null. */
std::string result_at(const nlohmann::ordered_json &summary,
                      const std::string &result);

/** The number there, which may be infinite; none if it is none. */
std::optional<double> number_at(const nlohmann::ordered_json &summary,
                                const std::string &result);

/** Add all results that a summary has, those without parts. */
void add_results(const nlohmann::ordered_json &summary,
                 std::set<std::string> &results);

/**
 * The results of @p known that are @p result but for a letter or two that are
 * no digits, which count: as names in quotes, or nothing.
 */
std::string misspelt_for(const std::string &result,
                         const std::set<std::string> &known);

/** The message on a @p result that is not among those known. */
std::string unknown_result(const std::string &result,
                           const std::set<std::string> &known);
} // namespace Voussoir

#endif
