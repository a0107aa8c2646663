// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/bounds.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** The bounds of what may be anything. */
const Bounds unbounded = {Interval::whole(),
                          {{Interval::whole(), Interval::whole()}}};

/** The largest exponent that is not taken by the logarithm. */
constexpr double largest_integer_power = 1e6;

bool is_number(const Interval &a)
{
  return singleton(a) && std::isfinite(a.lower());
}

/** a^n for the integer @p n. */
Interval integer_power(const Interval &a, const int n)
{
  return n < 0 ? 1. / boost::numeric::pow(a, -n) : boost::numeric::pow(a, n);
}

/** a^p for p > 0 where a is not negative. */
Bounds positive_power(const Bounds &a, const double p)
{
  const auto power = [&](const double exponent) {
    const double first = std::pow(a.value.lower(), exponent);
    const double last = std::pow(a.value.upper(), exponent);
    return Interval(std::min(first, last), std::max(first, last));
  };
  return chain(a, power(p), p * power(p - 1.));
}
} // namespace

double magnitude(const Interval &a)
{
  return std::max(std::abs(a.lower()), std::abs(a.upper()));
}

bool excludes_zero(const Interval &a)
{
  return a.lower() > 0. || a.upper() < 0.;
}

bool is_zero(const Interval &a)
{
  return a.lower() == 0. && a.upper() == 0.;
}

Bounds operator+(const Bounds &a, const Bounds &b)
{
  return {a.value + b.value,
          {{a.slope[0] + b.slope[0], a.slope[1] + b.slope[1]}}};
}

Bounds operator-(const Bounds &a, const Bounds &b)
{
  return {a.value - b.value,
          {{a.slope[0] - b.slope[0], a.slope[1] - b.slope[1]}}};
}

Bounds operator*(const Bounds &a, const Bounds &b)
{
  Bounds result = {a.value * b.value, {}};
  for (unsigned int i = 0; i < 2; ++i)
    result.slope[i] = a.slope[i] * b.value + a.value * b.slope[i];
  return result;
}

Bounds operator/(const Bounds &a, const Bounds &b)
{
  if (!excludes_zero(b.value))
    return unbounded;
  Bounds result = {a.value / b.value, {}};
  for (unsigned int i = 0; i < 2; ++i)
    result.slope[i] = (a.slope[i] - result.value * b.slope[i]) / b.value;
  return result;
}

Bounds operator-(const Bounds &a)
{
  return {-a.value, {{-a.slope[0], -a.slope[1]}}};
}

Bounds pow(const Bounds &a, const Bounds &b)
{
  if (is_number(b.value) && b.value.lower() == std::rint(b.value.lower()) &&
      std::abs(b.value.lower()) < largest_integer_power)
  {
    const int n = static_cast<int>(b.value.lower());
    if (n == 0)
      return {1., {}};
    if (n > 0 || excludes_zero(a.value))
      return chain(a, integer_power(a.value, n),
                   double(n) * integer_power(a.value, n - 1));
  }
  if (is_number(b.value) && b.value.lower() > 0. && a.value.lower() >= 0.)
    return positive_power(a, b.value.lower());
  if (!(a.value.lower() > 0.))
    return unbounded;
  const Bounds product = b * chain(a, log(a.value), 1. / a.value);
  return chain(product, exp(product.value), exp(product.value));
}

Bounds atan2(const Bounds &y, const Bounds &x)
{
  const double pi = std::acos(-1.);
  Bounds angle = {Interval(-pi, pi), unbounded.slope};
  const Interval square = pow(y.value, 2) + pow(x.value, 2);
  if (square.lower() > 0.)
    for (unsigned int i = 0; i < 2; ++i)
      angle.slope[i] = (x.value * y.slope[i] - y.value * x.slope[i]) / square;
  return angle;
}

Bounds chain(const Bounds &a, const Interval &value, const Interval &derivative)
{
  return {value, {{derivative * a.slope[0], derivative * a.slope[1]}}};
}

Bounds either(const Bounds &a, const Bounds &b)
{
  return {hull(a.value, b.value), unbounded.slope};
}
} // namespace Voussoir
