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

/** A function of an interval: the range of one of a number. */
using Range = Interval (*)(const Interval &);
/** SmoothFunction::bounds. */
using BoundsOf = std::function<Bounds(const Bounds &)>;

/** The bounds of a function that is real everywhere. */
BoundsOf everywhere(const Range range, const Range derivative)
{
  return [=](const Bounds &a) {
    return chain(a, range(a.value), derivative(a.value));
  };
}

/**
 * The bounds of a function that increases from @p least to @p most, where alone
 * it is real, with the @p derivative inside.
 */
BoundsOf increasing(double (*f)(double),
                    const double least,
                    const double most,
                    const Range derivative)
{
  return [=](const Bounds &a) -> Bounds {
    const bool is_inside = a.value.lower() > least && a.value.upper() < most;
    if (!is_inside && !(a.value.upper() >= least && a.value.lower() <= most))
      return {Interval::whole(), {{Interval::whole(), Interval::whole()}}};
    const Interval range(f(std::max(a.value.lower(), least)),
                         f(std::min(a.value.upper(), most)));
    return chain(a, range, is_inside ? derivative(a.value) : Interval::whole());
  };
}

Interval square(const Interval &v)
{
  return boost::numeric::pow(v, 2);
}

/** Across a pole the tangent does not increase. */
Interval derivative_of_tangent(const Interval &v)
{
  const Interval range = tan(v);
  return std::isfinite(magnitude(range)) ? 1. + square(range)
                                         : Interval::whole();
}
} // namespace

const std::vector<SmoothFunction> &smooth_functions()
{
  namespace numeric = boost::numeric;
  // The digits of the derivatives of logarithms.
  static const double ln_2 = std::log(2.), ln_10 = std::log(10.);
  static const BoundsOf logarithm = increasing(
      std::log, 0., infinity, [](const Interval &v) { return 1. / v; });
  static const BoundsOf minus_acos =
      increasing([](double x) { return -std::acos(x); }, -1., 1.,
                 [](const Interval &v) { return 1. / sqrt(1. - square(v)); });
  static const std::vector<SmoothFunction> functions = {
      {"sin", std::sin, everywhere(numeric::sin, numeric::cos)},
      {"cos", std::cos,
       everywhere(numeric::cos, [](const Interval &v) { return -sin(v); })},
      {"tan", std::tan, everywhere(numeric::tan, derivative_of_tangent)},
      {"asin", std::asin,
       increasing(std::asin, -1., 1.,
                  [](const Interval &v) { return 1. / sqrt(1. - square(v)); })},
      {"acos", std::acos, [](const Bounds &a) { return -minus_acos(a); }},
      {"atan", std::atan,
       increasing(std::atan, -infinity, infinity,
                  [](const Interval &v) { return 1. / (1. + square(v)); })},
      {"sinh", std::sinh, everywhere(numeric::sinh, numeric::cosh)},
      {"cosh", std::cosh, everywhere(numeric::cosh, numeric::sinh)},
      {"tanh", std::tanh,
       everywhere(numeric::tanh,
                  [](const Interval &v) { return 1. - square(tanh(v)); })},
      {"asinh", std::asinh,
       increasing(std::asinh, -infinity, infinity,
                  [](const Interval &v) { return 1. / sqrt(1. + square(v)); })},
      {"acosh", std::acosh,
       increasing(std::acosh, 1., infinity,
                  [](const Interval &v) { return 1. / sqrt(square(v) - 1.); })},
      {"atanh", std::atanh,
       increasing(std::atanh, -1., 1.,
                  [](const Interval &v) { return 1. / (1. - square(v)); })},
      {"exp", std::exp, everywhere(numeric::exp, numeric::exp)},
      {"ln", std::log, logarithm},
      {"log", std::log, logarithm},
      {"log2", std::log2,
       increasing(std::log2, 0., infinity,
                  [](const Interval &v) { return 1. / (ln_2 * v); })},
      {"log10", std::log10,
       increasing(std::log10, 0., infinity,
                  [](const Interval &v) { return 1. / (ln_10 * v); })},
      {"sqrt", std::sqrt,
       increasing(std::sqrt, 0., infinity,
                  [](const Interval &v) { return 0.5 / sqrt(v); })}};
  return functions;
}

const std::vector<SteppedFunction> &stepped_functions()
{
  static const std::vector<SteppedFunction> functions = {
      {"abs", [](double x) { return std::abs(x); }, 0., 0.},
      {"sign", [](double x) { return double(x > 0.) - double(x < 0.); }, 0.,
       0.},
      {"floor", std::floor, 0., 1.},
      {"ceil", std::ceil, 0., 1.},
      {"rint", [](double x) { return std::floor(x + 0.5); }, 0.5, 1.}};
  return functions;
}
} // namespace Voussoir
