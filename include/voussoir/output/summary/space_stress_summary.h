// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_space_stress_summary_h
#define voussoir_output_summary_space_stress_summary_h

#include <voussoir/output/space_results.h>
#include <voussoir/terminal/terminal.h>

#include <nlohmann/json.hpp>

namespace Voussoir
{
/** The extremes of the stress inside, for summary.json. */
nlohmann::ordered_json json_of_stress(const SpaceResults &results);

/** Say them. */
void show_stress(Terminal &terminal, const SpaceResults &results);
} // namespace Voussoir

#endif
