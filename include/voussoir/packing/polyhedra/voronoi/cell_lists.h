// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_cell_lists_h
#define voussoir_packing_polyhedra_voronoi_cell_lists_h

#include <voussoir/packing/polyhedra/cell_faces.h>
#include <voussoir/packing/polyhedra/voronoi/small_features.h>

namespace Voussoir
{
/**
 * The lists of cells from those of their faces, where a face between two cells
 * is there once: that of the other cell runs the other way, and both are
 * CellFaces::shared. The faces of a cell are in the order of the sites behind
 * them; vertices that no face has are left out.
 *
 * @param faces a site below the number of cells is a cell.
 * @param places of the vertices; lengths.
 */
CellFaces cells_of(const VertexFaces &faces,
                   const std::vector<dealii::Point<3>> &places,
                   unsigned int n_cells);
} // namespace Voussoir

#endif
