// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_summary_h
#define voussoir_output_summary_summary_h

#include <voussoir/output/results.h>
#include <voussoir/terminal/terminal.h>

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>
#include <string>

namespace Voussoir
{
/** The name of the file for programs. */
inline const std::string summary_json = "summary.json";

/** @{ */
/** The summary of a run, for programs; numbers may be infinite. */
nlohmann::ordered_json summary_of(const Results &results);
nlohmann::ordered_json summary_of(const Collapse &collapse);
/** @} */

/** @{ */
/** Write the summary as JSON, with null for what is not finite. */
void write_summary_json(std::ostream &out, const Results &results);
void write_summary_json(std::ostream &out, const Collapse &collapse);
/** @} */

/**
 * Show the size of a packing, and of its supports the ends of the first and the
 * number of the others.
 */
void show_packing(Terminal &terminal, const Packing<2> &packing);

/** The summary of a run in a few lines, for people. */
void show_summary(Terminal &terminal, const Results &results);
} // namespace Voussoir

#endif
