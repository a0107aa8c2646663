// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_space_defect_table_h
#define voussoir_output_report_space_defect_table_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * A table of defects by kinds as HTML, the largest of each first, and of each
 * the first ten; empty if there are none.
 *
 * @param cells gives the names of blocks.
 */
std::string html_of_defects(const CellFaces &cells,
                            const std::vector<CellDefect> &defects);
} // namespace Voussoir

#endif
