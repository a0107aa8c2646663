// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_convex_pieces_h
#define voussoir_packing_convex_pieces_h

#include <voussoir/packing/packing.h>

#include <deal.II/base/point.h>

#include <vector>

namespace Voussoir
{
/**
 * Cut a simple polygon along diagonals into convex ones, by the method of
 * Hertel and Mehlhorn: at most four times as many as are needed. Two pieces
 * have one diagonal in common or none, so that they form a tree.
 *
 * @param ring its vertices, counterclockwise.
 * @return of each piece the numbers of its vertices, counterclockwise.
 */
std::vector<std::vector<unsigned int>>
convex_pieces(const std::vector<dealii::Point<2>> &ring);

/** True if no two sides of a closed polygon cross or touch. */
bool is_simple(const std::vector<dealii::Point<2>> &ring);

/** True if a point is inside a simple polygon, however it runs. */
bool is_inside(const dealii::Point<2> &p,
               const std::vector<dealii::Point<2>> &ring);

/** The vertices of a cell. */
std::vector<dealii::Point<2>> ring_of(const Packing<2> &packing,
                                      unsigned int cell);

/** The centroid of a polygon, counterclockwise; a length. */
dealii::Point<2> centroid(const std::vector<dealii::Point<2>> &ring);
} // namespace Voussoir

#endif
