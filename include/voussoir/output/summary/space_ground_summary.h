// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_space_ground_summary_h
#define voussoir_output_summary_space_ground_summary_h

#include <voussoir/output/space_results.h>
#include <voussoir/terminal/terminal.h>

#include <nlohmann/json.hpp>

namespace Voussoir
{
/** The reactions of the supports, for summary.json: a list. */
nlohmann::ordered_json json_of_reactions(const SpaceResults &answer);

/** Say them; of many the first. Nothing without forces or supports. */
void show_reactions(Terminal &terminal, const SpaceResults &answer);
} // namespace Voussoir

#endif
