// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_voronoi_cells_h
#define voussoir_packing_polyhedra_voronoi_voronoi_cells_h

#include <voussoir/packing/points_file.h>
#include <voussoir/packing/polyhedra/cell_faces.h>
#include <voussoir/packing/polyhedra/voronoi/convex_polyhedron.h>

namespace Voussoir
{
/**
 * The Voronoi cells of @p generators, cut at the planes of @p domain, with the
 * generators as centres.
 *
 * The faces are the duals of the edges of one Delaunay triangulation (CGAL,
 * exact predicates) of the generators and of four guards, see VoronoiSites. A
 * face that reaches beyond a plane is cut there by FaceCutter, so that a vertex
 * in a plane lies in it to rounding, exactly if the plane is axis-parallel, and
 * the corners are the domain's own. Each vertex is computed once, for all cells
 * around it.
 *
 * Features smaller than the resolution, 1e-12 of the mean size of a cell or
 * rounding of the coordinates if that is more, are left out, in all cells
 * alike: see without_small_features(). Vertices lie in the planes of their
 * faces to rounding of the size of the domain, or to some ten times the
 * resolution where features were left out. Cells that meet in an edge or a
 * point only, as eight cubes of a grid do, are not neighbours.
 *
 * The faces of a cell are in the order of the cells behind them, and then of
 * the domain's faces; interior ones are all CellFaces::shared.
 *
 * @throws InputError if there is no generator, if one is not inside, or if the
 *   distance of two is less than a hundred times the resolution.
 */
CellFaces voronoi_cells(const PointList<3> &generators,
                        const ConvexPolyhedron &domain);
} // namespace Voussoir

#endif
