// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_fixed_cells_h
#define voussoir_packing_polyhedra_fixed_cells_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <vector>

namespace Voussoir
{
/**
 * The cells of a Packing<3> with more of them fixed: those for which @p
 * is_fixed is true (one entry for each cell) come behind all others, before
 * those that are fixed already; the order among each of these is kept.
 */
CellFaces with_fixed_cells(const CellFaces &cells,
                           const std::vector<bool> &is_fixed);
} // namespace Voussoir

#endif
