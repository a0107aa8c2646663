// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_voronoi_cells_h
#define voussoir_packing_voronoi_cells_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/points_file.h>

namespace Voussoir
{
/** An axis-parallel rectangle; lengths. */
struct Rectangle
{
  dealii::Point<2> lower_left;
  dealii::Point<2> upper_right;

  double area() const;
};

/**
 * The Voronoi cells of @p generators, cut at the sides of @p rectangle, with
 * the generators as centres.
 *
 * The cells are the duals of one Delaunay triangulation (CGAL, exact
 * predicates) of the generators and of the mirror images, in a side, of those
 * whose cell reaches over that side: the cell of a point and that of its
 * image meet exactly along the side. Vertices closer together than rounding
 * can resolve are one vertex, so that cells which meet in a point only, as
 * four squares of a grid do, are not neighbours.
 *
 * @throws InputError if two generators coincide or one is not inside.
 */
CellLoops voronoi_cells(const PointList &generators,
                        const Rectangle &rectangle);
} // namespace Voussoir

#endif
