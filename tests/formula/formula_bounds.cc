// SPDX-License-Identifier: LGPL-2.1-or-later

// A formula that is read from muParser's byte code has muParser's values; its
// bounds in a box hold its values there, and those of its derivatives the
// quotients of differences where it does not jump.

#include <voussoir/base/text.h>
#include <voussoir/formula/expression.h>

#include "tests.h"
#include <random>

namespace test_formula_bounds
{
using namespace Voussoir;

using Numbers = std::mt19937;

double between(Numbers &numbers, const double low, const double high)
{
  return std::uniform_real_distribution<double>(low, high)(numbers);
}

/**
 * A formula in x and y with so many levels, by choice with real values only: a
 * comparison with what is not a number is false, of which bounds know nothing.
 */
std::string
random_formula(Numbers &numbers, const unsigned int depth, const bool is_real)
{
  const auto choice = [&](const std::vector<std::string> &words) {
    return words[numbers() % words.size()];
  };
  if (depth == 0)
    return numbers() % 3 == 0 ? text(between(numbers, 0., 2.))
                              : choice({"x", "y"});
  const auto part = [&] { return random_formula(numbers, depth - 1, is_real); };
  const std::string positive = is_real ? "0.1+abs" : "";
  switch (numbers() % 7)
  {
  case 0: return "(" + part() + choice({"+", "-", "*"}) + part() + ")";
  case 1:
    // Whether two formulas are the same function, bounds do not know.
    return "(" + part() +
           (numbers() % 3 == 0
                ? choice({"==", "!="}) + text(between(numbers, 0., 2.))
                : choice({"<", "<=", ">", ">="}) + part()) +
           choice({"&&", "||"}) + part() + ")";
  case 2:
    return "(" + part() + "<" + part() + "?" + part() + ":" + part() + ")";
  case 3:
    return choice({"min", "max", "sum", "avg"}) + "(" + part() + "," + part() +
           "," + part() + ")";
  case 4:
    return choice({"", "pow"}) == ""
               ? "((" + positive + "(" + part() + "))" + choice({"^", "/"}) +
                     "(" + positive + "(" + part() + ")))"
               : choice({"atan2", "pow"}) + "(" + positive + "(" + part() +
                     ")," + part() + ")";
  case 5:
    return choice({"-", "+", "sin", "cos", "tan", "atan", "sinh", "cosh",
                   "tanh", "asinh", "exp", "abs", "sign", "floor", "ceil",
                   "rint"}) +
           "(" + part() + ")";
  default:
    const std::string argument = "(" + part() + ")";
    if (!is_real)
      return choice({"asin", "acos", "acosh", "atanh", "ln", "log", "log2",
                     "log10", "sqrt"}) +
             argument;
    return choice({"asin(sin", "acos(cos", "acosh(1+abs", "atanh(0.9*sin",
                   "ln(0.1+abs", "log(0.1+abs", "log2(0.1+abs", "log10(0.1+abs",
                   "sqrt(abs"}) +
           argument + ")";
  }
}

/** Whether the values are those of @p expression in points next to @p p. */
bool agree(const double value,
           const Expression &expression,
           const std::vector<double> &p)
{
  const double here = expression(p);
  double slack = 1e-12 * std::abs(here);
  for (const double step : {-1e-14, 1e-14})
    for (unsigned int i = 0; i < 2; ++i)
    {
      std::vector<double> beside = p;
      beside[i] *= 1. + step;
      const double difference = std::abs(expression(beside) - here);
      if (std::isfinite(difference))
        slack = std::max(slack, difference);
    }
  return (std::isnan(value) && std::isnan(here)) || value == here ||
         std::abs(value - here) <= slack;
}

/** Whether @p a is in @p bounds, to rounding of what it came from. */
bool holds(const Interval &bounds, const double a, const double rounding)
{
  const double slack = rounding * (1. + std::abs(a));
  return std::isnan(a) ||
         (bounds.lower() - slack <= a && a <= bounds.upper() + slack);
}

void run()
{
  const InvalidOperationsAllowed of_random_formulas;
  Numbers numbers(1);
  unsigned int n_values = 0, n_bounds = 0, n_slopes = 0, n_formulas = 0;
  bool values_agree = true, bounds_hold = true, slopes_hold = true;
  for (; n_formulas < 3000; ++n_formulas)
  {
    const bool is_real = n_formulas % 4 > 0;
    const std::string formula =
        random_formula(numbers, 1 + n_formulas % 5, is_real);
    const Expression expression(formula, {"x", "y"}, "a test");
    const Formula &tree = expression.formula();
    for (unsigned int k = 0; k < 20; ++k)
    {
      const std::vector<double> p = {between(numbers, -2., 2.),
                                     between(numbers, -2., 2.)};
      values_agree &= agree(tree.value(p), expression, p);
      n_values += std::isfinite(expression(p));

      const double reach = std::pow(10., between(numbers, -4., 0.));
      const double t = between(numbers, -1., 1.), s = between(numbers, -1., 1.);
      std::vector<Bounds> box(2);
      for (unsigned int i = 0; i < 2; ++i)
      {
        box[i].value = Interval(p[i] - reach, p[i] + reach);
        box[i].slope[i] = reach;
      }
      std::vector<Formula::Crossing> crossings;
      const Bounds bounds = tree.bounds(
          box, p, Formula::Limits(tree.n_jumps(), Interval::whole()),
          crossings);
      // What may jump is to be cut first.
      if (!is_real || !crossings.empty() || std::isnan(bounds.value.lower()))
        continue;
      const bool has_bounds = std::isfinite(magnitude(bounds.value));
      const double here = expression({p[0] + t * reach, p[1] + s * reach});
      const double rounding = 1e-12 * (1. + magnitude(bounds.value));
      bounds_hold &= !has_bounds || holds(bounds.value, here, rounding);
      n_bounds += has_bounds;
      if (std::isnan(bounds.slope[0].lower()) || std::isnan(here))
        continue;
      const double there = expression({p[0] - t * reach, p[1] + s * reach});
      const double quotient = (here - there) / (2. * t);
      if (std::isfinite(quotient) && has_bounds && std::abs(t) > 0.1)
      {
        slopes_hold &= holds(bounds.slope[0], quotient, 100. * rounding);
        n_slopes += std::isfinite(magnitude(bounds.slope[0]));
      }
    }
  }
  check("values of muParser", values_agree);
  check("bounds hold the values", bounds_hold);
  check("bounds of derivatives hold quotients of differences", slopes_hold);
  check("so many were finite",
        n_values > 20000 && n_bounds > 10000 && n_slopes > 5000);
}

const RoomTest test("formula_bounds", run);
} // namespace test_formula_bounds
