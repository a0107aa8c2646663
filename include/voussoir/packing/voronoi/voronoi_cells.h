// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_voronoi_voronoi_cells_h
#define voussoir_packing_voronoi_voronoi_cells_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/points_file.h>
#include <voussoir/packing/voronoi/convex_polygon.h>

namespace Voussoir
{
/**
 * The Voronoi cells of @p generators, cut at the sides of @p polygon, with the
 * generators as centres.
 *
 * The cells are the duals of one Delaunay triangulation (CGAL, exact
 * predicates) of the generators, and of three points so far away that they
 * change no cell inside but make all cells finite. A cell that reaches over a
 * side is cut there by CellCutter, so that a vertex on a side lies on it to
 * rounding, exactly if the side is axis-parallel, and the corners are the
 * polygon's own. Vertices closer together than rounding can resolve are one
 * vertex, so that cells which meet in a point only, as four squares of a grid
 * do, are not neighbours.
 *
 * @throws InputError if two generators coincide or one is not inside.
 */
CellLoops voronoi_cells(const PointList<2> &generators,
                        const ConvexPolygon &polygon);
} // namespace Voussoir

#endif
