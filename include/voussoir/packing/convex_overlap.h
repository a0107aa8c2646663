// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_convex_overlap_h
#define voussoir_packing_convex_overlap_h

#include <deal.II/base/point.h>

#include <functional>
#include <vector>

namespace Voussoir
{
/**
 * The depth of the overlap of two convex polygons, the shortest displacement
 * along a normal of a side that ends it; a length, not positive if they do not
 * overlap. Of a depth of at most @p enough, only that it is no more.
 *
 * @param a, b counterclockwise; sides without a length have no normal.
 */
double overlap_depth(const std::vector<dealii::Point<2>> &a,
                     const std::vector<dealii::Point<2>> &b,
                     double enough);

/** What two convex polygons that overlap have in common. */
std::vector<dealii::Point<2>>
common_part(std::vector<dealii::Point<2>> common,
            const std::vector<dealii::Point<2>> &other);

/**
 * The part of a convex polygon where a linear function of the place is not
 * negative; empty if there is none.
 */
std::vector<dealii::Point<2>>
part_where(const std::vector<dealii::Point<2>> &ring,
           const std::function<double(const dealii::Point<2> &)> &function);
} // namespace Voussoir

#endif
