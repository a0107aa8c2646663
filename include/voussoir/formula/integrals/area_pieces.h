// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_integrals_area_pieces_h
#define voussoir_formula_integrals_area_pieces_h

#include <voussoir/formula/integrals/discontinuities.h>

#include <optional>
#include <vector>

namespace Voussoir
{
/** A part of a convex polygon. */
struct AreaPiece
{
  /** Convex, counterclockwise; lengths. */
  std::vector<dealii::Point<2>> corners;
  /** The only jump that may cross it, if there is one. */
  std::optional<Discontinuities::Crossing> crossing;
  /** The coordinate, 0 or 1, along which its argument increases or decreases
   * everywhere, so that the curve is a graph over the other one. */
  unsigned int along = 0;
  /** The known bounds of the jumps there. */
  Discontinuities::Limits limits;
  /** True if it is so small that it does not count, and is not cut again. */
  bool is_uncertain = false;
};

/**
 * Cut the convex polygon with these @p corners, counterclockwise, along the @p
 * jumps that cross it.
 *
 * Straight jumps, of which the argument is linear there, cut it exactly. Else
 * it is cut in halves until bounds show that no jump crosses a piece, or one as
 * a graph over one of the coordinates (Saye, *SIAM Journal on Scientific
 * Computing* 37 (2015), A993), or the piece is negligible.
 */
std::vector<AreaPiece> area_pieces(const std::vector<dealii::Point<2>> &corners,
                                   const Discontinuities &jumps);
} // namespace Voussoir

#endif
