// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_packing_summary_h
#define voussoir_output_summary_packing_summary_h

#include <voussoir/output/space_results.h>
#include <voussoir/packing/polyhedra/packing.h>
#include <voussoir/terminal/terminal.h>

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace Voussoir
{
/** Show what a packing in space consists of, and what it rests on. */
void show_packing(Terminal &terminal, const Packing<3> &packing);

/**
 * What blocks in space consist of, and what was found, for programs; numbers
 * may be infinite.
 *
 * @param defects of the blocks, of which kinds and numbers are in it.
 */
nlohmann::ordered_json summary_of(const SpaceResults &answer,
                                  const std::vector<CellDefect> &defects);
/** Write that with a title as JSON, with null for what is not finite. */
void write_summary_json(std::ostream &out,
                        const SpaceResults &answer,
                        const std::string &title,
                        const std::vector<CellDefect> &defects);
} // namespace Voussoir

#endif
