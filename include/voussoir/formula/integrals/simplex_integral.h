// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_integrals_simplex_integral_h
#define voussoir_formula_integrals_simplex_integral_h

#include <deal.II/base/point.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace Voussoir
{
/** Values that are integrated together. */
using IntegratedValues = std::vector<double>;

/** The integrals of some functions. */
struct SimplexIntegral
{
  /** Of each. */
  IntegratedValues values;
  /** The estimated error of the worst. */
  double error = 0.;
  /** The integral of the size of the largest. */
  double size = 0.;
  /** Add that over another domain. */
  void add(const SimplexIntegral &other);
};

/**
 * The integrals over a triangle in space, or a tetrahedron, by the corners:
 * by rules of the degrees 9 and 5 (Witherden and Vincent, *Computers and
 * Mathematics with Applications* 69 (2015), 1232), of which the difference is
 * the error. Where it is more than rounding, on both halves, up to 20 times:
 * polynomials of the degree 5 are exact, jumps are within a thousandth.
 *
 * @param corners three, or four.
 * @param f gives the values at a point; always as many.
 */
SimplexIntegral integral_over_simplex(
    const std::vector<dealii::Point<3>> &corners,
    const std::function<void(const dealii::Point<3> &, IntegratedValues &)> &f);
} // namespace Voussoir

#endif
