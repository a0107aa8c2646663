// SPDX-License-Identifier: LGPL-2.1-or-later

// Integrals and first moments over triangles: 10,000 random triangles cut by a
// line or a disc against closed forms, to 1e-10 or with a warning; smooth
// functions, with 20 periods too, against Gauss' rule of many points; and jumps
// that meet in the triangle.

#include <voussoir/base/geometry.h>
#include <voussoir/formula/expression.h>
#include <voussoir/formula/integrals/inaccuracies.h>
#include <voussoir/formula/integrals/triangle_integral.h>

#include <deal.II/base/quadrature_lib.h>

#include "tests.h"
#include <random>

namespace test_triangle_integrals
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

using Numbers = std::mt19937;
using Triangle = std::array<Point<2>, 3>;

double between(Numbers &numbers, const double low, const double high)
{
  return std::uniform_real_distribution<double>(low, high)(numbers);
}

Triangle random_triangle(Numbers &numbers)
{
  for (;;)
  {
    Triangle triangle;
    for (Point<2> &corner : triangle)
      corner = {between(numbers, -1., 1.), between(numbers, -1., 1.)};
    if (cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) > 1e-3)
      return triangle;
  }
}

/** Of the formula in the first component, about the first corner. */
TriangleIntegral integral(const std::string &formula, const Triangle &triangle)
{
  const Expression expression(formula, {"x", "y"}, "a test");
  const Discontinuities jumps({expression.formula()}, {});
  return triangle_integral(
      triangle, triangle[0],
      [&](const Point<2> &p) {
        return Tensor<1, 2>({expression({p[0], p[1]}), 0.});
      },
      jumps);
}

/** Whether the user is told nothing. */
bool is_accurate(const TriangleIntegral &found)
{
  Inaccuracies inaccuracies("a test");
  inaccuracies.look_at(found.error, found.size, found.uncertain,
                       [] { return std::string("here"); });
  return inaccuracies.warnings().empty();
}

/** An area and its first moments. */
struct Area
{
  double area = 0.;
  Tensor<1, 2> moment;

  void add(const double part, const Point<2> &centroid)
  {
    area += part;
    moment += part * Tensor<1, 2>(centroid);
  }

  /** About another point. */
  Tensor<1, 2> moment_about(const Point<2> &p) const
  {
    return moment - area * Tensor<1, 2>(p);
  }
};

/** The part of a triangle where n . x < c. */
Area part_below(const Triangle &triangle, const Tensor<1, 2> &n, const double c)
{
  std::vector<Point<2>> corners;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const Point<2> &p = triangle[i], &q = triangle[(i + 1) % 3];
    const double here = n * p - c, there = n * q - c;
    if (here < 0.)
      corners.push_back(p);
    if ((here < 0.) != (there < 0.))
      corners.push_back(p + here / (here - there) * (q - p));
  }
  Area area;
  for (unsigned int i = 1; i + 1 < corners.size(); ++i)
    area.add(0.5 * cross(corners[i] - corners[0], corners[i + 1] - corners[0]),
             Point<2>((Tensor<1, 2>(corners[0]) + corners[i] + corners[i + 1]) /
                      3.));
  return area;
}

/**
 * The part of a triangle in a disc around the origin: signed triangles of the
 * origin with what is inside of its sides, and sectors for what is outside.
 */
Area part_in_disc(const Triangle &triangle, const double r)
{
  Area area;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const Point<2> &a = triangle[i];
    const Tensor<1, 2> d = triangle[(i + 1) % 3] - a;
    std::vector<double> cuts = {0.};
    const double p = (a * d) / d.norm_square();
    const double q = (a * a - r * r) / d.norm_square();
    if (p * p > q)
      for (const double root :
           {-p - std::sqrt(p * p - q), -p + std::sqrt(p * p - q)})
        if (root > 0. && root < 1.)
          cuts.push_back(root);
    cuts.push_back(1.);
    for (unsigned int k = 0; k + 1 < cuts.size(); ++k)
    {
      const Point<2> from = a + cuts[k] * d, to = a + cuts[k + 1] * d;
      const Point<2> middle = a + 0.5 * (cuts[k] + cuts[k + 1]) * d;
      if (middle.norm() < r)
        area.add(0.5 * cross(from, to),
                 Point<2>((Tensor<1, 2>(from) + to) / 3.));
      else
      {
        const double begin = std::atan2(from[1], from[0]);
        const double end =
            begin + std::atan2(cross(from, to), Tensor<1, 2>(from) * to);
        area.area += 0.5 * r * r * (end - begin);
        area.moment += r * r * r / 3. *
                       Tensor<1, 2>({std::sin(end) - std::sin(begin),
                                     std::cos(begin) - std::cos(end)});
      }
    }
  }
  return area;
}

/** The largest error of a function that has one value in a part and another
 * outside, relative to the integral of its size. */
double error_of(const TriangleIntegral &found,
                const Triangle &triangle,
                const Area &part,
                const double inside,
                const double outside)
{
  Area whole;
  whole.add(
      0.5 * cross(triangle[1] - triangle[0], triangle[2] - triangle[0]),
      Point<2>((Tensor<1, 2>(triangle[0]) + triangle[1] + triangle[2]) / 3.));
  const double value = outside * whole.area + (inside - outside) * part.area;
  const Tensor<1, 2> moment =
      outside * whole.moment_about(triangle[0]) +
      (inside - outside) * part.moment_about(triangle[0]);
  const double size =
      std::max(std::abs(inside), std::abs(outside)) * whole.area;
  return std::max(
             std::abs(found.value[0] - value),
             (Tensor<1, 2>({found.moment[0][0], found.moment[0][1]}) - moment)
                 .norm()) /
         size;
}

void check_cuts()
{
  Numbers numbers(1);
  double worst_line = 0., worst_disc = 0.;
  unsigned int n_warned = 0, n_cut = 0;
  constexpr unsigned int n_triangles = 10000;
  for (unsigned int k = 0; k < n_triangles; ++k)
  {
    const Triangle triangle = random_triangle(numbers);
    const double inside = between(numbers, -1., 1.);
    const double outside = between(numbers, -1., 1.);
    const std::string values =
        " ? " + bracketed(inside) + " : " + bracketed(outside);
    Area part;
    TriangleIntegral found;
    double *worst = nullptr;
    if (k % 2 == 0)
    {
      const double angle = between(numbers, 0., 2. * dealii::numbers::PI);
      const Tensor<1, 2> n({std::cos(angle), std::sin(angle)});
      const double c = between(numbers, -1., 1.);
      part = part_below(triangle, n, c);
      found = integral(bracketed(n[0]) + "*x+" + bracketed(n[1]) + "*y<" +
                           bracketed(c) + values,
                       triangle);
      worst = &worst_line;
    }
    else
    {
      // Also discs inside the triangle, and small ones.
      const double r = std::pow(10., between(numbers, -3., 0.));
      part = part_in_disc(triangle, r);
      found = integral("x^2+y^2<" + bracketed(r) + "^2" + values, triangle);
      worst = &worst_disc;
    }
    if (is_accurate(found))
      *worst =
          std::max(*worst, error_of(found, triangle, part, inside, outside));
    else
      ++n_warned;
    n_cut +=
        part.area > 0. && part.area < 0.499 * cross(triangle[1] - triangle[0],
                                                    triangle[2] - triangle[0]);
  }
  check_error("half-planes", worst_line, 1e-10);
  check_error("discs", worst_disc, 1e-10);
  check_error("part of them with a warning", n_warned / double(n_triangles),
              1e-3);
  check("many of them cut the triangle", n_cut > n_triangles / 3);
}

/** By Gauss' rule in coordinates that collapse at the first corner. */
void check_smooth()
{
  Numbers numbers(2);
  const dealii::QGauss<2> gauss(160);
  double worst = 0.;
  bool all_accurate = true;
  for (unsigned int k = 0; k < 60; ++k)
  {
    const Triangle triangle = random_triangle(numbers);
    const double waves =
        2. * dealii::numbers::PI * std::pow(10., between(numbers, -3., 1.));
    const double angle = between(numbers, 0., 2. * dealii::numbers::PI);
    const double u = waves * std::cos(angle), v = waves * std::sin(angle);
    const bool is_sine = k % 2 == 0;
    const std::string formula = std::string(is_sine ? "sin" : "exp") + "(" +
                                bracketed(u) + "*x+" + bracketed(v) + "*y)";
    const TriangleIntegral found = integral(formula, triangle);
    double value = 0., size = 0.;
    Tensor<1, 2> moment;
    for (unsigned int q = 0; q < gauss.size(); ++q)
    {
      const double s = gauss.point(q)[0], t = gauss.point(q)[1];
      const Tensor<1, 2> arm = s * ((1. - t) * (triangle[1] - triangle[0]) +
                                    t * (triangle[2] - triangle[0]));
      const Point<2> x = triangle[0] + arm;
      const double argument = u * x[0] + v * x[1];
      const double f =
          (is_sine ? std::sin(argument) : std::exp(argument)) *
          gauss.weight(q) * s *
          cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
      value += f;
      size += std::abs(f);
      moment += f * arm;
    }
    worst = std::max(
        {worst, std::abs(found.value[0] - value) / size,
         (Tensor<1, 2>({found.moment[0][0], found.moment[0][1]}) - moment)
                 .norm() /
             size});
    all_accurate &= is_accurate(found);
  }
  check_error("exp and sin, up to 20 periods", worst, 1e-10);
  check("without a warning", all_accurate);
}

void run()
{
  check_cuts();
  check_smooth();

  const Triangle unit = {{{0., 0.}, {1., 0.}, {0., 1.}}};
  const double pi = dealii::numbers::PI;
  const auto compare = [&](const std::string &formula, const double value) {
    const TriangleIntegral found = integral(formula, unit);
    check_error(formula, std::abs(found.value[0] - value), 1e-12);
    if (!is_accurate(found))
      std::cout << "FAILED: a warning" << std::endl;
  };
  compare("x>0.2 && x<0.3 && y>0.1 && y<0.4", 0.03);
  compare("abs(x-0.25)<0.05 && abs(y-0.25)<0.15", 0.03);
  compare("(x-0.3)^2+(y-0.3)^2 < 0.01", 0.01 * pi);
  compare("sqrt((x-0.3)^2+(y-0.3)^2) < 0.001 ? 1e6 : 0", pi);
  // Half of a lens, with a corner where two arcs meet.
  compare("x^2+y^2 < 0.25 && (x-0.5)^2+y^2 < 0.25",
          0.25 * std::acos(0.5) - 0.125 * std::sqrt(0.75));
  // A peak between all points, that bounds find.
  compare("1 + exp(-((x-0.3)^2+(y-0.3)^2)/1e-8)", 0.5 + 1e-8 * pi);
  compare("1e8*exp(-((x-0.3)^2+(y-0.3)^2)/1e-8)", pi);
  // The same where a point of the rule meets it: its size is not that seen.
  compare("1e8*exp(-((x-1/3)^2+(y-1/3)^2)/1e-8)", pi);
  compare("cos(3*x) + 1e4*exp(-((x-1/3)^2+(y-1/3)^2)/1e-8)",
          (1. - std::cos(3.)) / 9. + 1e-4 * pi);
  compare("min(x, y)", 1. / 12.);
  compare("floor(4*x)", 0.4375);
  compare("sqrt(x)", 4. / 15.);
}

const RoomTest test("triangle_integrals", run);
} // namespace test_triangle_integrals
