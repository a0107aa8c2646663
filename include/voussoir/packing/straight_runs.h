// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_straight_runs_h
#define voussoir_packing_straight_runs_h

#include <voussoir/packing/packing.h>

#include <vector>

namespace Voussoir
{
/** Edges of the rim of a packing that follow each other on a straight line. */
struct StraightRun
{
  dealii::Point<2> start; /**< counterclockwise around the packing; a length */
  dealii::Point<2> end;   /**< of the last edge; a length */
  /** The numbers of the edges, as given to straight_runs(), in that order. */
  std::vector<unsigned int> edges;
};

/**
 * Put edges of the rim, each running counterclockwise around its cell with the
 * normal outward, together into runs: an edge is followed by one that starts
 * where it ends and has the same normal within rounding.
 */
std::vector<StraightRun>
straight_runs(const std::vector<Packing<2>::BoundaryEdge> &edges);
} // namespace Voussoir

#endif
