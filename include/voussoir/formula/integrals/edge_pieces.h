// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_integrals_edge_pieces_h
#define voussoir_formula_integrals_edge_pieces_h

#include <voussoir/formula/integrals/discontinuities.h>

#include <vector>

namespace Voussoir
{
/** A part of an edge, in the coordinate from 0 to 1 along it. */
struct EdgePiece
{
  double begin; /**< where it begins */
  double end;   /**< where it ends */
  /** True if the function is known to be smooth inside. */
  bool is_smooth;
  /** The known bounds of the jumps there. */
  Discontinuities::Limits limits;
};

/**
 * Cut the edge from @p a to @p b where @p jumps cross it within @p limits.
 *
 * Bounds of the arguments of the jumps say where they cannot cross; elsewhere
 * parts are halved until an argument has one root or none, which is then found
 * to rounding. Not smooth are pieces along which a step runs, to within
 * rounding, and those too short to be cut again.
 *
 * @return the pieces, in no order.
 */
std::vector<EdgePiece> edge_pieces(const dealii::Point<2> &a,
                                   const dealii::Point<2> &b,
                                   const Discontinuities &jumps,
                                   const Discontinuities::Limits &limits);

/**
 * The root of the distance of @p crossing on the straight line from @p a to @p
 * b, where it has opposite signs, in the coordinate from 0 to 1 along it.
 */
double root_between(const dealii::Point<2> &a,
                    const dealii::Point<2> &b,
                    double distance_a,
                    double distance_b,
                    const Discontinuities &jumps,
                    const Discontinuities::Crossing &crossing);
} // namespace Voussoir

#endif
