// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_convex_hull_h
#define voussoir_packing_polyhedra_voronoi_convex_hull_h

#include <voussoir/packing/polyhedra/cell_faces.h>

#include <vector>

namespace Voussoir
{
/**
 * The convex hull of @p points (CGAL, exact predicates) as one cell. Triangles
 * of the hull whose corners lie in one plane, up to 1e-9 of the size of the
 * hull, are one face; a point of which only two faces are left is no corner.
 * The corners are numbered in the order of the points.
 *
 * @param points finite; lengths.
 * @throws InputError if there are fewer than four points, or all lie within
 *   1e-9 of their size of one plane.
 */
CellFaces convex_hull(const std::vector<dealii::Point<3>> &points);
} // namespace Voussoir

#endif
