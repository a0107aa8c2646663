// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_integrals_edge_integral_h
#define voussoir_formula_integrals_edge_integral_h

#include <voussoir/formula/integrals/discontinuities.h>

#include <functional>

namespace Voussoir
{
/** The integral of a function over a straight edge. */
struct EdgeIntegral
{
  /** Its mean; in its unit. */
  double mean;
  /**
   * The mean of the function times s / |e|, with the distance s from the middle
   * of the edge along it; in its unit.
   */
  double moment;
  /** The error of both at most, by estimate; in its unit. */
  double error;
  /** The mean of the size of the function, roughly; in its unit. */
  double size;
  /** The part of the edge along which a jump may run; from 0 to 1. */
  double uncertain;
};

/**
 * Integrate a function over the edge from @p a to @p b.
 *
 * On each of its edge_pieces() the function is smooth, and integrated by
 * integrate(), on halves of them as long as its bounds do not exclude that a
 * peak hides between the points. Where a jump runs along the edge, to within
 * rounding, the value in the middle is taken, and counts as an error.
 *
 * @param a,b lengths.
 * @param f the function; it may throw.
 * @param jumps of the function, which is their one formula, if they have any.
 */
EdgeIntegral
edge_integral(const dealii::Point<2> &a,
              const dealii::Point<2> &b,
              const std::function<double(const dealii::Point<2> &)> &f,
              const Discontinuities &jumps);
} // namespace Voussoir

#endif
