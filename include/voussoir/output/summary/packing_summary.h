// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_summary_packing_summary_h
#define voussoir_output_summary_packing_summary_h

#include <voussoir/analyses/space_analysis.h>
#include <voussoir/packing/polyhedra/packing.h>
#include <voussoir/terminal/terminal.h>

#include <iosfwd>
#include <string>

namespace Voussoir
{
/** Show what a packing in space consists of, and what it rests on. */
void show_packing(Terminal &terminal, const Packing<3> &packing);

/**
 * Write what blocks in space consist of, and what was found, as JSON.
 *
 * @param defects of the blocks, of which kinds and numbers are written.
 */
void write_summary_json(std::ostream &out,
                        const SpaceAnswer &answer,
                        const std::string &title,
                        const std::vector<CellDefect> &defects);
} // namespace Voussoir

#endif
