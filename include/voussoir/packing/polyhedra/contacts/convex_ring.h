// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_convex_ring_h
#define voussoir_packing_polyhedra_contacts_convex_ring_h

#include <voussoir/base/geometry.h>
#include <voussoir/base/invalid_index.h>

#include <deal.II/base/point.h>

#include <boost/container/small_vector.hpp>

#include <vector>

namespace Voussoir
{
/** A corner of a polygon in the coordinates of a plane. */
struct RingCorner
{
  /** Its coordinates; lengths. */
  dealii::Point<2> at;
  /** The number of the vertex that it is; invalid_index if it is none. */
  unsigned int vertex = invalid_index;
};

/**
 * The corners of a convex polygon, counterclockwise. Few corners need no
 * memory of their own.
 */
using ConvexRing = boost::container::small_vector<RingCorner, 8>;

/** Some convex polygons in one plane. */
using ConvexRings = std::vector<ConvexRing>;

/** A line with a direction, in the coordinates of a plane. */
class DirectedLine
{
public:
  /** The line from @p a to @p b, which must not be the same. */
  DirectedLine(const dealii::Point<2> &a, const dealii::Point<2> &b)
      : start(a), along((b - a) / a.distance(b))
  {}

  /** The distance of a point, positive to the left; a length. */
  double distance(const dealii::Point<2> &p) const
  {
    return cross(along, p - start);
  }

private:
  dealii::Point<2> start;
  dealii::Tensor<1, 2> along;
};

/** The two parts of a convex polygon beside a line. */
struct RingHalves
{
  /** The part to the left of the line; empty if there is none. */
  ConvexRing left;
  /** The part to its right; empty if there is none. */
  ConvexRing right;
};

/**
 * Cut a convex polygon along a line. Corners nearer to it than @p tolerance
 * count as on it and stay where they are, so that no part is narrower than
 * that for them; the two parts add up to the whole.
 *
 * @param tolerance a length.
 */
RingHalves
cut(const ConvexRing &ring, const DirectedLine &line, double tolerance);

/**
 * What a convex polygon has in common with another, by Sutherland and Hodgman;
 * empty if that is nothing. Corners of @p ring that are outside of the other by
 * less than @p tolerance stay where they are. Sides of the other that are no
 * longer than that do not cut.
 *
 * @param tolerance a length.
 */
ConvexRing
common_part(ConvexRing ring, const ConvexRing &other, double tolerance);

/**
 * The rest of some convex polygons without another, cut along its sides.
 * Parts as narrow as the tolerance are left out, and what overlaps less than
 * that stays whole.
 *
 * @param tolerance a length.
 */
ConvexRings
without(const ConvexRings &rings, const ConvexRing &other, double tolerance);

/** The area of a polygon; L^2. */
double area(const ConvexRing &ring);

/** The least distance of two parallel lines around a polygon; a length. */
double width(const ConvexRing &ring);
} // namespace Voussoir

#endif
