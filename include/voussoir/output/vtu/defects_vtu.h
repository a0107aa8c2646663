// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_vtu_defects_vtu_h
#define voussoir_output_vtu_defects_vtu_h

#include <voussoir/packing/polyhedra/cell_defects.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace Voussoir
{
/** Its name. */
inline const std::string defects_vtu = "defects.vtu";

/** True if some defect has a place, so that there is something to write. */
bool have_places(const std::vector<CellDefect> &defects);

/**
 * The places of defects as a VTK unstructured grid of points, with the fields
 * kind, cell, face (-1 for none), count and size (L) of each.
 */
void write_defects_vtu(std::ostream &out,
                       const std::vector<CellDefect> &defects);
} // namespace Voussoir

#endif
