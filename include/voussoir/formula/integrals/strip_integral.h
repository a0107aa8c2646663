// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_integrals_strip_integral_h
#define voussoir_formula_integrals_strip_integral_h

#include <voussoir/formula/integrals/area_pieces.h>
#include <voussoir/formula/integrals/gauss_kronrod.h>

#include <functional>

namespace Voussoir
{
/** Six integrals over the same piece. */
using AreaSums = Integrals<6>;

/**
 * The integral over a piece that one curve may cross as a graph: across it, up
 * to the curve and from there on, in strips between corners and ends of the
 * curve, all by integrate().
 *
 * @param jumps that the piece was cut along.
 * @param f the functions; smooth on either side of the curve.
 * @param is_exhausted true once no more evaluations may be spent on parts: each
 *   rule is then applied once.
 */
Integral<AreaSums>
strip_integral(const AreaPiece &piece,
               const Discontinuities &jumps,
               const std::function<AreaSums(const dealii::Point<2> &)> &f,
               const std::function<bool()> &is_exhausted);
} // namespace Voussoir

#endif
