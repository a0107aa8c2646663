// SPDX-License-Identifier: LGPL-2.1-or-later

// Means and first moments over edges: 10,000 random edges with one or two jumps
// at random places against closed forms, to 1e-10 or with a warning; smooth
// functions, with 20 periods too; jumps by min, max, abs, floor and conditions
// in conditions; and jumps that run along the edge.

#include <voussoir/base/text.h>
#include <voussoir/formula/expression.h>
#include <voussoir/formula/integrals/edge_integral.h>
#include <voussoir/formula/integrals/inaccuracies.h>

#include "tests.h"
#include <random>

namespace test_edge_integrals
{
using namespace Voussoir;
using dealii::Point;

using Numbers = std::mt19937;

double between(Numbers &numbers, const double low, const double high)
{
  return std::uniform_real_distribution<double>(low, high)(numbers);
}

EdgeIntegral
integral(const std::string &formula, const Point<2> &a, const Point<2> &b)
{
  const Expression expression(formula, {"x", "y"}, "a test");
  const Discontinuities jumps({expression.formula()}, {});
  return edge_integral(
      a, b,
      [&](const Point<2> &p) {
        return expression({p[0], p[1]});
      },
      jumps);
}

/** Whether the user is told nothing. */
bool is_accurate(const EdgeIntegral &found)
{
  Inaccuracies inaccuracies("a test");
  inaccuracies.look_at(found.error, found.size, found.uncertain,
                       [] { return std::string("here"); });
  return inaccuracies.warnings().empty();
}

/** The mean and the moment of a constant in a part of the edge. */
void add_part(const double value,
              const double begin,
              const double end,
              double &mean,
              double &moment)
{
  mean += value * (end - begin);
  moment += value * (end - begin) * (0.5 * (begin + end) - 0.5);
}

void check_jumps()
{
  Numbers numbers(1);
  double worst = 0.;
  unsigned int n_warned = 0;
  constexpr unsigned int n_edges = 10000;
  for (unsigned int k = 0; k < n_edges; ++k)
  {
    const double size = std::pow(10., between(numbers, -3., 3.));
    Point<2> a, b;
    for (unsigned int i = 0; i < 2; ++i)
    {
      a[i] = between(numbers, -size, size);
      b[i] = between(numbers, -size, size);
    }
    // A line across the edge at t, in a random direction.
    const auto side_of_line = [&](const double t) {
      const Point<2> p = a + t * (b - a);
      const double angle = between(numbers, 0., 2. * dealii::numbers::PI);
      const double nx = std::cos(angle), ny = std::sin(angle);
      const double across = nx * (b - a)[0] + ny * (b - a)[1];
      return std::make_pair(bracketed(nx) + "*(x-" + bracketed(p[0]) + ")+" +
                                bracketed(ny) + "*(y-" + bracketed(p[1]) +
                                ") < 0",
                            across > 0.);
    };
    double t = between(numbers, 0., 1.);
    const double before = between(numbers, -1., 1.);
    const double after = between(numbers, -1., 1.);
    double mean = 0., moment = 0.;
    std::string formula;
    if (k % 2 == 0)
    {
      const auto [line, rises] = side_of_line(t);
      formula = line + " ? " + bracketed(rises ? before : after) + " : " +
                bracketed(rises ? after : before);
      add_part(before, 0., t, mean, moment);
      add_part(after, t, 1., mean, moment);
    }
    else
    {
      // A patch, most of them narrow.
      double end = t + std::pow(10., between(numbers, -6., 0.)) * (1. - t);
      const auto [first, first_rises] = side_of_line(t);
      const auto [last, last_rises] = side_of_line(end);
      formula = (first_rises ? "(" + first + ") == 0" : first) + " && " +
                (last_rises ? last : "(" + last + ") == 0") + " ? " +
                bracketed(after) + " : " + bracketed(before);
      add_part(before, 0., t, mean, moment);
      add_part(after, t, end, mean, moment);
      add_part(before, end, 1., mean, moment);
    }
    const EdgeIntegral found = integral(formula, a, b);
    const double scale = std::max(std::abs(before), std::abs(after));
    if (is_accurate(found))
      worst = std::max({worst, std::abs(found.mean - mean) / scale,
                        std::abs(found.moment - moment) / scale});
    else
      ++n_warned;
  }
  check_error("one or two jumps at random places", worst, 1e-10);
  check_error("part of them with a warning", n_warned / double(n_edges), 1e-3);
}

/** exp and sin along an edge, whose means are known. */
void check_smooth()
{
  Numbers numbers(2);
  double worst = 0.;
  bool all_accurate = true;
  for (unsigned int k = 0; k < 1000; ++k)
  {
    const Point<2> a(between(numbers, -1., 1.), between(numbers, -1., 1.));
    const Point<2> b(between(numbers, -1., 1.), between(numbers, -1., 1.));
    const double u = between(numbers, -10., 10.) / (b - a).norm();
    const double v = between(numbers, -10., 10.) / (b - a).norm();
    const double w = u * (b - a)[0] + v * (b - a)[1];
    const double periods = between(numbers, 0.1, 20.);
    const double frequency = 2. * dealii::numbers::PI * periods / (b[0] - a[0]);
    // Along t from 0 to 1: exp(w t) times its value at the start.
    const double start = std::exp(u * a[0] + v * a[1]);
    const EdgeIntegral e =
        integral("exp(" + bracketed(u) + "*x+" + bracketed(v) + "*y)", a, b);
    const double mean = start * std::expm1(w) / w;
    const double moment =
        start * (std::exp(w) / w - std::expm1(w) / w / w) - 0.5 * mean;
    const EdgeIntegral s =
        integral("sin(" + bracketed(frequency) + "*x)", a, b);
    const double omega = frequency * (b[0] - a[0]);
    const double sine_mean =
        (std::cos(frequency * a[0]) - std::cos(frequency * b[0])) / omega;
    worst = std::max({worst, std::abs(e.mean - mean) / mean,
                      std::abs(e.moment - moment) / mean,
                      std::abs(s.mean - sine_mean)});
    all_accurate &= is_accurate(e) && is_accurate(s);
  }
  check_error("exp and sin with up to 20 periods", worst, 1e-10);
  check("without a warning", all_accurate);
}

void run()
{
  check_jumps();
  check_smooth();

  const Point<2> a(0., 0.), b(1., 0.);
  const auto compare = [&](const std::string &formula, const double mean) {
    const EdgeIntegral found = integral(formula, a, b);
    check_error(formula, std::abs(found.mean - mean), 1e-13);
    if (!is_accurate(found))
      std::cout << "FAILED: a warning" << std::endl;
  };
  compare("floor(10*x)", 4.5);
  compare("rint(10*x)", 5.);
  compare("ceil(10*x)", 5.5);
  compare("abs(x-0.3)", 0.29);
  compare("min(x, 0.3, 1-x)", 0.3 * 0.4 + 0.09);
  compare("max(x, 0.3)", 0.09 + 0.455);
  compare("sign(x-0.1)", 0.8);
  compare("abs(x-0.5) < 0.1 || abs(x-0.8) < 0.01 ? 10 : 0", 2.2);
  compare("(x-0.5)^2 + y^2 < 0.01", 0.2);
  compare("(x < 0.5 ? x : 1-x) > 0.4 ? 1 : 0", 0.2);
  compare("sqrt(x)", 2. / 3.);
  compare("sqrt(abs(x-0.5))", std::sqrt(0.5) * 2. / 3.);
  compare("if(x > 0.25, 4, 0)", 3.);
  // A peak between all points, that bounds find.
  compare("1 + exp(-((x-0.5123)/1e-5)^2)",
          1. + 1e-5 * std::sqrt(dealii::numbers::PI));
  compare("(x-0.2)*(x-0.2000001)*(x-0.7) < 0 ? 1 : 0", 0.7 - 1e-7);

  // A comparison with the very line that the edge is on is exact; with what is
  // the same but for rounding it is a warning, unless nothing jumps.
  compare("y <= 0 ? 3 : 4", 3.);
  const Point<2> c(0., 1. - 2e-16), d(1., 1. + 2e-16);
  const EdgeIntegral along = integral("y < 1 ? 3 : 4", c, d);
  check("a jump along the edge is a warning", !is_accurate(along));
  check("a kink along it is none", is_accurate(integral("abs(y-1)+x", c, d)));
  check("nor the same value on both sides",
        is_accurate(integral("y < 1 ? x : x + 1e-16", c, d)));
}

const RoomTest test("edge_integrals", run);
} // namespace test_edge_integrals
