// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_voronoi_random_points_h
#define voussoir_packing_voronoi_random_points_h

#include <voussoir/packing/points_file.h>
#include <voussoir/packing/voronoi/cell_size.h>
#include <voussoir/packing/voronoi/convex_polygon.h>

namespace Voussoir
{
/**
 * @p n points drawn uniformly over @p rectangle; a seed gives the same ones.
 * They are in the order in which a Hilbert curve meets them, so that points
 * close to each other mostly have numbers close to each other.
 */
PointList<2> random_points(unsigned int n,
                           unsigned int seed,
                           const Rectangle &rectangle = {{0., 0.}, {1., 1.}});

/**
 * @p n independent points in @p polygon whose density is proportional to
 * 1/h(x, y)^2, so that their Voronoi cells have sizes in proportion to the
 * @p size h; a seed gives the same points, in the order of a Hilbert curve.
 *
 * The polygon is cut into triangles, from which a PointSource draws.
 *
 * @throws InputError naming the place if h is not finite and positive, or seems
 *   to vanish.
 */
PointList<2> random_points(unsigned int n,
                           unsigned int seed,
                           const ConvexPolygon &polygon,
                           const CellSize<2> &size);
} // namespace Voussoir

#endif
