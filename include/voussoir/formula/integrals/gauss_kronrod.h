// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_integrals_gauss_kronrod_h
#define voussoir_formula_integrals_gauss_kronrod_h

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

namespace Voussoir
{
/**
 * N integrals that are found together, and last the integral of a constant that
 * says how large the integrands are: errors are relative to the largest of
 * them, so that integrals may cancel.
 */
template <unsigned int N>
struct Integrals
{
  /** The integrals, then that of the constant. */
  std::array<double, N + 1> values;

  /** All of them @p value; Boost begins with zero. */
  Integrals(const double value = 0.) { values.fill(value); }

  /** @{ */
  /** Element by element. */
  Integrals &operator+=(const Integrals &other)
  {
    for (unsigned int k = 0; k <= N; ++k)
      values[k] += other.values[k];
    return *this;
  }
  friend Integrals operator+(Integrals a, const Integrals &b) { return a += b; }
  friend Integrals operator-(const Integrals &a, const Integrals &b)
  {
    return a + -b;
  }
  friend Integrals operator*(Integrals a, const double factor)
  {
    for (double &value : a.values)
      value *= factor;
    return a;
  }
  friend Integrals operator*(const double factor, const Integrals &a)
  {
    return a * factor;
  }
  friend Integrals operator-(const Integrals &a) { return a * -1.; }
  /** @} */

  /** The largest size of an element. */
  friend double abs(const Integrals &a)
  {
    double largest = 0.;
    for (const double value : a.values)
      largest = std::max(largest, std::abs(value));
    return largest;
  }
};

/** An integral and the estimate of its error. */
template <typename T>
struct Integral
{
  /** An Integrals or a double. */
  T value;
  /** As a bound to each element. */
  double error;
  /** The integral of abs() of the function, roughly. */
  double size;
};

/**
 * The integral of @p f, which gives a double or an Integrals, from @p begin to
 * @p end by one application of Gauss-Kronrod's rule of @p n_points.
 */
template <unsigned int n_points, typename F>
auto integrate_once(const F &f, const double begin, const double end)
{
  // Boost's estimate of the error is that of the interval from -1 to 1, and its
  // own bisection compares it with integrals over parts as it is.
  double error = 0., size = 0.;
  const auto value =
      boost::math::quadrature::gauss_kronrod<double, n_points>::integrate(
          f, begin, end, 0, 0., &error, &size);
  return Integral<std::decay_t<decltype(value)>>{
      value, error * 0.5 * (end - begin), size};
}

/**
 * The integral to @p tolerance of abs() of it, if that can be: parts with the
 * largest errors are halved as long as need be.
 *
 * The function may be smooth, or have the roots of distances at its ends: then
 * u^2 (3 - 2u) is put for the variable, which makes them smooth.
 */
template <unsigned int n_points, typename F>
auto integrate(const F &f,
               const double begin,
               const double end,
               const double tolerance)
{
  using std::abs;
  const auto direct = integrate_once<n_points>(f, begin, end);
  if (direct.error <= tolerance * abs(direct.value))
    return direct;

  const auto substituted = [&](const double u) {
    const double slope = 6. * u * (1. - u) * (end - begin);
    return slope * f(begin + u * u * (3. - 2. * u) * (end - begin));
  };
  struct Part
  {
    double begin, end;
    std::decay_t<decltype(direct)> integral;
    bool operator<(const Part &other) const
    {
      return integral.error < other.integral.error;
    }
  };
  constexpr unsigned int n_max_parts = 100;
  std::vector<Part> parts;
  auto sum = direct;
  const auto add = [&](const double a, const double b) {
    parts.push_back({a, b, integrate_once<n_points>(substituted, a, b)});
    sum.value += parts.back().integral.value;
    sum.error += parts.back().integral.error;
    std::push_heap(parts.begin(), parts.end());
  };
  sum.value = 0.;
  sum.error = 0.;
  add(0., 1.);
  while (sum.error > tolerance * abs(sum.value) && parts.size() < n_max_parts)
  {
    std::pop_heap(parts.begin(), parts.end());
    const Part worst = parts.back();
    parts.pop_back();
    sum.value += -worst.integral.value;
    sum.error -= worst.integral.error;
    const double middle = 0.5 * (worst.begin + worst.end);
    add(worst.begin, middle);
    add(middle, worst.end);
  }
  return sum;
}
} // namespace Voussoir

#endif
