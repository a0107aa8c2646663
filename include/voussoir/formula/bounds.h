// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_bounds_h
#define voussoir_formula_bounds_h

#include <boost/numeric/interval.hpp>

#include <array>

namespace Voussoir
{
/**
 * A closed interval, without directed rounding: bounds are true to rounding
 * errors, for which the caller must allow.
 */
using Interval = boost::numeric::interval<
    double,
    boost::numeric::interval_lib::policies<
        boost::numeric::interval_lib::save_state_nothing<
            boost::numeric::interval_lib::rounded_transc_exact<double>>,
        boost::numeric::interval_lib::checking_base<double>>>;

/** The largest distance of a point of @p a from zero. */
double magnitude(const Interval &a);

/** True if zero is neither inside @p a nor at its ends. */
bool excludes_zero(const Interval &a);

/** True if @p a is the one number zero. */
bool is_zero(const Interval &a);

/**
 * Bounds of a function of two coordinates from -1 to 1, and of its derivatives:
 * interval arithmetic with automatic differentiation (Moore, Kearfott and
 * Cloud, *Introduction to Interval Analysis*, 2009).
 */
struct Bounds
{
  /** Of the function. */
  Interval value = 0.;
  /** Of its derivative by each coordinate. */
  std::array<Interval, 2> slope = {{Interval(0.), Interval(0.)}};
};

/** @{ */
/** The bounds of the sum, difference, product, ... of two functions. */
Bounds operator+(const Bounds &a, const Bounds &b);
Bounds operator-(const Bounds &a, const Bounds &b);
Bounds operator*(const Bounds &a, const Bounds &b);
Bounds operator/(const Bounds &a, const Bounds &b);
Bounds operator-(const Bounds &a);
Bounds pow(const Bounds &a, const Bounds &b);
Bounds atan2(const Bounds &y, const Bounds &x);
/** @} */

/**
 * The bounds of a function of a function.
 *
 * @param a of the inner one.
 * @param value,derivative of the outer one on the range of the inner one.
 */
Bounds
chain(const Bounds &a, const Interval &value, const Interval &derivative);

/** The bounds of what may be either of two functions from place to place. */
Bounds either(const Bounds &a, const Bounds &b);
} // namespace Voussoir

#endif
