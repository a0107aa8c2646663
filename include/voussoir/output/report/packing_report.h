// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_packing_report_h
#define voussoir_output_report_packing_report_h

#include <voussoir/output/space_results.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * Write blocks in space, and what was found of them, as a page; see
 * write_space_report().
 *
 * @param title of the page; may be empty.
 * @param warnings to be shown below the picture.
 * @param defects of the blocks, below these.
 */
void write_packing_report(std::ostream &out,
                          const SpaceResults &answer,
                          const std::string &title,
                          const std::vector<std::string> &warnings,
                          const std::vector<CellDefect> &defects);
} // namespace Voussoir

#endif
