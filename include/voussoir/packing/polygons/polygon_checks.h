// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_polygon_checks_h
#define voussoir_packing_polygons_polygon_checks_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/polygon_list.h>

namespace Voussoir
{
/**
 * Check that every ring is a simple polygon that could be a cell, by exact
 * predicates, and turn those that run clockwise.
 *
 * A ring is at fault, and broken, if a vertex is not finite or repeated, there
 * are fewer than three, or the polygon has no area, crosses or touches itself,
 * or is a sliver.
 */
void check_and_orient(PolygonList &polygons);

/** The root of the mean area of a cell that is not broken; a length. */
double mean_size(const PolygonList &polygons);

/**
 * 1e-10 of @p size, a length, or 16 units of rounding of the largest coordinate
 * if that is more: the tolerance for coordinates that are right to rounding.
 */
double tolerance_of(const PolygonList &polygons, double size);

/**
 * The matching tolerance for coordinates that are right to rounding; a length.
 * It is 1e-10 of the mean size of a cell, or 16 units of rounding of the
 * largest coordinate if that is more. A random Voronoi packing of a million
 * cells has a shortest edge of about 1e-7 of that size.
 */
double automatic_tolerance(const PolygonList &polygons);

/**
 * Check that the tolerance can be resolved by the coordinates, and that no cell
 * is so thin that its opposite sides could be taken for one another: that is a
 * fault.
 *
 * @throws InputError naming the tolerance if it cannot.
 */
void check_tolerance(PolygonList &polygons, double tolerance);

/**
 * Find the pairs of polygons that overlap more deeply than the tolerance, a
 * length, or are there twice. The depth of an overlap is the shortest
 * displacement that ends it; between convex polygons it is along the normal of
 * a side of one of them (the theorem of separating axes). Others are cut into
 * convex ones first.
 */
void check_overlaps(PolygonList &polygons, double tolerance);

/** What a drawing may leave open between two cells. */
struct GapLimits
{
  /** The distance up to which sides that face each other touch; a length. */
  double touching;
  /** The widest gap; a length. */
  double widest;
  /** How deep cells may overlap; a length. */
  double tolerance;
};

/** The gaps up to a twentieth of the mean size of a cell. */
GapLimits limits_of_gaps(const PolygonList &polygons,
                         double tolerance,
                         double joint_width);

/**
 * Name the cells that float, and the gaps between the others: no faults by
 * themselves, but what to look at beside the faults.
 */
void look_around(PolygonList &polygons, const GapLimits &limits);

/**
 * The gaps between sides that face each other, where nothing lies between and
 * that no joint closes; one for each pair of cells, the widest. A gap is an
 * open joint that carries nothing, which is easily mistaken for a fault of the
 * load.
 *
 * @param cells before or after they are matched.
 */
std::vector<Gap> find_gaps(const CellLoops &cells, const GapLimits &limits);

/** A sentence on gaps, how wide they are and what closes them; or none. */
std::string describe_gaps(const std::vector<Gap> &gaps);
} // namespace Voussoir

#endif
