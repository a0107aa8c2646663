// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_voronoi_random_points_h
#define voussoir_packing_polyhedra_voronoi_random_points_h

#include <voussoir/packing/points_file.h>
#include <voussoir/packing/polyhedra/voronoi/convex_polyhedron.h>
#include <voussoir/packing/voronoi/cell_size.h>

namespace Voussoir
{
/**
 * @p n points drawn uniformly over @p box; a seed gives the same ones, on every
 * machine. They are in the order in which a Hilbert curve meets them, so that
 * points close to each other mostly have numbers close to each other.
 */
PointList<3> random_points(unsigned int n, unsigned int seed, const Box &box);

/**
 * @p n independent points in @p polyhedron whose density is proportional to
 * 1/h(x, y, z)^3, so that their Voronoi cells have sizes in proportion to the
 * @p size h; a seed gives the same points, in the order of a Hilbert curve.
 *
 * The polyhedron is cut into tetrahedra, from which a PointSource draws.
 *
 * @throws InputError naming the place if h is not finite and positive, or seems
 *   to vanish.
 */
PointList<3> random_points(unsigned int n,
                           unsigned int seed,
                           const ConvexPolyhedron &polyhedron,
                           const CellSize<3> &size);
} // namespace Voussoir

#endif
