// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_link_summary_h
#define voussoir_output_summary_link_summary_h

#include <voussoir/output/results.h>
#include <voussoir/terminal/terminal.h>

#include <nlohmann/json.hpp>

namespace Voussoir
{
/** The links with their forces, for summary.json. */
nlohmann::ordered_json links_summary(const Results &results);

/** Show the forces of links, the first of them. */
void show_link_forces(Terminal &terminal, const Results &results);

/** Show the links of a scene that is not solved. */
void show_links(Terminal &terminal, const Scene &scene);
} // namespace Voussoir

#endif
