// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/formula/functions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

/**
 * The bounds of a function that increases from @p least to @p most, where alone
 * it is real, with the @p derivative inside.
 */
template <typename Derivative>
Bounds increasing(const Bounds &a,
                  double (*f)(double),
                  const double least,
                  const double most,
                  const Derivative &derivative)
{
  const bool is_inside = a.value.lower() > least && a.value.upper() < most;
  if (!is_inside && !(a.value.upper() >= least && a.value.lower() <= most))
    return {Interval::whole(), {{Interval::whole(), Interval::whole()}}};
  const Interval range(f(std::max(a.value.lower(), least)),
                       f(std::min(a.value.upper(), most)));
  return chain(a, range, is_inside ? derivative(a.value) : Interval::whole());
}

Bounds logarithm(const Bounds &a)
{
  return increasing(
      a, [](double x) { return std::log(x); }, 0., infinity,
      [](const Interval &v) { return 1. / v; });
}

Interval square(const Interval &v)
{
  return boost::numeric::pow(v, 2);
}
} // namespace

const std::vector<SmoothFunction> &smooth_functions()
{
  // The digits of the derivatives of logarithms.
  static const double ln_2 = std::log(2.), ln_10 = std::log(10.);
  static const std::vector<SmoothFunction> functions = {
      {"sin", [](double x) { return std::sin(x); },
       [](const Bounds &a) {
         return chain(a, sin(a.value), cos(a.value));
       }},
      {"cos", [](double x) { return std::cos(x); },
       [](const Bounds &a) {
         return chain(a, cos(a.value), -sin(a.value));
       }},
      {"tan", [](double x) { return std::tan(x); },
       [](const Bounds &a) {
         const Interval range = tan(a.value);
         // Across a pole it does not increase.
         return chain(a, range,
                      std::isfinite(magnitude(range)) ? 1. + square(range)
                                                      : Interval::whole());
       }},
      {"asin", [](double x) { return std::asin(x); },
       [](const Bounds &a) {
         return increasing(
             a, [](double x) { return std::asin(x); }, -1., 1.,
             [](const Interval &v) { return 1. / sqrt(1. - square(v)); });
       }},
      {"acos", [](double x) { return std::acos(x); },
       [](const Bounds &a) {
         const Bounds minus = increasing(
             a, [](double x) { return -std::acos(x); }, -1., 1.,
             [](const Interval &v) { return 1. / sqrt(1. - square(v)); });
         return -minus;
       }},
      {"atan", [](double x) { return std::atan(x); },
       [](const Bounds &a) {
         return increasing(
             a, [](double x) { return std::atan(x); }, -infinity, infinity,
             [](const Interval &v) { return 1. / (1. + square(v)); });
       }},
      {"sinh", [](double x) { return std::sinh(x); },
       [](const Bounds &a) {
         return chain(a, sinh(a.value), cosh(a.value));
       }},
      {"cosh", [](double x) { return std::cosh(x); },
       [](const Bounds &a) {
         return chain(a, cosh(a.value), sinh(a.value));
       }},
      {"tanh", [](double x) { return std::tanh(x); },
       [](const Bounds &a) {
         const Interval range = tanh(a.value);
         return chain(a, range, 1. - square(range));
       }},
      {"asinh", [](double x) { return std::asinh(x); },
       [](const Bounds &a) {
         return increasing(
             a, [](double x) { return std::asinh(x); }, -infinity, infinity,
             [](const Interval &v) { return 1. / sqrt(1. + square(v)); });
       }},
      {"acosh", [](double x) { return std::acosh(x); },
       [](const Bounds &a) {
         return increasing(
             a, [](double x) { return std::acosh(x); }, 1., infinity,
             [](const Interval &v) { return 1. / sqrt(square(v) - 1.); });
       }},
      {"atanh", [](double x) { return std::atanh(x); },
       [](const Bounds &a) {
         return increasing(
             a, [](double x) { return std::atanh(x); }, -1., 1.,
             [](const Interval &v) { return 1. / (1. - square(v)); });
       }},
      {"exp", [](double x) { return std::exp(x); },
       [](const Bounds &a) {
         return chain(a, exp(a.value), exp(a.value));
       }},
      {"ln", [](double x) { return std::log(x); }, logarithm},
      {"log", [](double x) { return std::log(x); }, logarithm},
      {"log2", [](double x) { return std::log2(x); },
       [](const Bounds &a) {
         return increasing(
             a, [](double x) { return std::log2(x); }, 0., infinity,
             [](const Interval &v) { return 1. / (ln_2 * v); });
       }},
      {"log10", [](double x) { return std::log10(x); },
       [](const Bounds &a) {
         return increasing(
             a, [](double x) { return std::log10(x); }, 0., infinity,
             [](const Interval &v) { return 1. / (ln_10 * v); });
       }},
      {"sqrt", [](double x) { return std::sqrt(x); },
       [](const Bounds &a) {
         return increasing(
             a, [](double x) { return std::sqrt(x); }, 0., infinity,
             [](const Interval &v) { return 0.5 / sqrt(v); });
       }}};
  return functions;
}

const std::vector<SteppedFunction> &stepped_functions()
{
  static const std::vector<SteppedFunction> functions = {
      {"abs", [](double x) { return std::abs(x); }, 0., 0.},
      {"sign", [](double x) { return double(x > 0.) - double(x < 0.); }, 0.,
       0.},
      {"floor", [](double x) { return std::floor(x); }, 0., 1.},
      {"ceil", [](double x) { return std::ceil(x); }, 0., 1.},
      {"rint", [](double x) { return std::floor(x + 0.5); }, 0.5, 1.}};
  return functions;
}
} // namespace Voussoir
