// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_space_drawing_order_h
#define voussoir_output_report_space_drawing_order_h

#include <voussoir/output/report/space/isometric_view.h>
#include <voussoir/packing/polyhedra/cell_faces.h>

#include <vector>

namespace Voussoir
{
/**
 * The order in which cells are drawn over one another, the farthest first. Two
 * cells whose hulls overlap in the picture are ordered by a plane of a face of
 * one of them that has the other on its outer side, as two convex cells that
 * touch have; if there is none, or if cells lie before one another in a circle,
 * by the nearness of their middles.
 *
 * @param drawn the numbers of cells, each once.
 * @param view with a unit of the order of the size of the whole.
 * @return the same numbers in that order.
 */
std::vector<unsigned int> drawing_order(const CellFaces &cells,
                                        const std::vector<unsigned int> &drawn,
                                        const IsometricView &view);
} // namespace Voussoir

#endif
