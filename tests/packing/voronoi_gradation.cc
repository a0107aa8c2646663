// SPDX-License-Identifier: LGPL-2.1-or-later

// Voronoi packings of polygons with graded cells: random points have a density
// of 1/h^2, Lloyd steps keep the gradation, only ratios of h matter; failures.

#include "tests.h"

namespace test_voronoi_gradation
{
using namespace Voussoir;

const std::string hexagon = "set Domain = polygon\n"
                            "set Polygon = 1, 0; 2, 0; 2.5, 0.8; 2, 1.6; "
                            "1, 1.6; 0.5, 0.8\n";

Packing<2> generate(const std::string &settings)
{
  VoronoiGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.parse_input_from_string(settings);
  return Packing<2>(generator.generate(".", Terminal::silent()));
}

/** The root of the mean area of the cells with centres between two x. */
double mean_size(const Packing<2> &packing, const double from, const double to)
{
  double area = 0.;
  unsigned int n = 0;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (packing.centre(c)[0] > from && packing.centre(c)[0] < to)
    {
      area += packing.area(c);
      ++n;
    }
  return std::sqrt(area / n);
}

/** The relative standard deviation of sqrt(area) / h. */
double spread(const Packing<2> &packing, const std::string &formula)
{
  const CellSize<2> size(formula, "size");
  double sum = 0., squares = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    const double ratio = std::sqrt(packing.area(c)) / size(packing.centre(c));
    sum += ratio / packing.n_cells();
    squares += ratio * ratio / packing.n_cells();
  }
  return std::sqrt(squares - sum * sum) / sum;
}

double largest_distance(const Packing<2> &a, const Packing<2> &b)
{
  double largest = 0.;
  for (unsigned int c = 0; c < a.n_cells(); ++c)
    largest = std::max(largest, a.centre(c).distance(b.centre(c)));
  return largest;
}

/** The number of n points left of x, over its standard deviation from n p. */
double deviation(const PointList<2> &list, const double x, const double p)
{
  const double n = list.points.size();
  const auto n_left =
      std::count_if(list.points.begin(), list.points.end(),
                    [&](const dealii::Point<2> &q) { return q[0] < x; });
  return std::abs(n_left - n * p) / std::sqrt(n * p * (1. - p));
}

void check_density()
{
  // In the unit square, with the density f over the integral of f.
  const ConvexPolygon square(Rectangle{{0., 0.}, {1., 1.}});
  const auto draw = [&](const std::string &h) {
    return random_points(200000, 3, square, CellSize<2>(h, "size"));
  };
  check("uniform", deviation(draw("7"), 0.3, 0.3) < 3.);
  check("h = 1 + x", deviation(draw("1 + x"), 0.5, 2. / 3.) < 3.);
  check("a jump", deviation(draw("x < 0.4321 ? 1 : 3"), 0.4321,
                            0.4321 / (0.4321 + 0.5679 / 9)) < 3.);
  // A narrow peak that no corner of a triangle sees at its highest.
  const double w = 0.001, c = 0.50123;
  const double left = std::atan(c / w), right = std::atan((1. - c) / w);
  check("a peak", deviation(draw("sqrt((x - 0.50123)^2 + 0.001^2)"), c + w,
                            (left + std::atan(1.)) / (left + right)) < 3.);

  // A triangle with a linear density: x has the density 2 (1 - x) uniformly.
  const ConvexPolygon triangle({{0., 0.}, {1., 0.}, {0., 1.}});
  check("a triangle",
        deviation(random_points(200000, 5, triangle, CellSize<2>("1", "size")),
                  0.5, 0.75) < 3.);
}

void check_gradation()
{
  const std::string many = hexagon + "set Number of points = 3000\n";
  const Packing<2> equal = generate(many);
  check("equal cells left and right",
        std::abs(mean_size(equal, 0., 1.5) / mean_size(equal, 1.5, 3.) - 1.) <
            0.05);
  const std::string jump = "set Cell size = x < 1.5 ? 1 : 3\n";
  const Packing<2> halves = generate(many + jump);
  check("cells three times as large on the right",
        std::abs(mean_size(halves, 1.5, 3.) / mean_size(halves, 0., 1.5) - 3.) <
            0.2);

  const std::string smooth = "set Cell size = 1 + 2*x\n";
  const Packing<2> random = generate(many + smooth);
  const Packing<2> lloyd = generate(many + smooth + "set Lloyd steps = 60\n");
  check("spread about the wanted size at random",
        std::abs(spread(random, "1 + 2*x") - 0.27) < 0.03);
  check("a third of that after Lloyd steps",
        spread(lloyd, "1 + 2*x") < 0.27 / 3);
  const auto ratio = [](const Packing<2> &packing) {
    return mean_size(packing, 2., 2.5) / mean_size(packing, 0.5, 1.);
  };
  check("cells twice as large at the right corner",
        std::abs(ratio(random) - 2.) < 0.2);
  check("which Lloyd steps keep",
        std::abs(ratio(lloyd) / ratio(random) - 1.) < 0.03);

  const Packing<2> scaled = generate(many + "set Cell size = (1 + 2*x) / 8\n");
  check_error("only ratios matter", largest_distance(random, scaled), 1e-15);
  const std::string rectangle = "set Number of points = 500\n";
  check_error("a constant is no gradation",
              largest_distance(generate(rectangle),
                               generate(rectangle + "set Cell size = 7")),
              0.);
  check_error("as many times as one likes",
              largest_distance(random, generate(many + smooth)), 0.);
}

void run()
{
  check_density();
  check_gradation();

  show_refusal([] { generate("set Domain = polygon"); });
  show_refusal([] {
    generate("set Domain = polygon\nset Polygon = 0, 0; 1, 0; 0.2, 0.2; 0, 1");
  });
  show_refusal([] { generate("set Cell size = x +"); });
  show_refusal([] { generate(hexagon + "set Cell size = x - 1.5"); });
  show_refusal([] { generate("set Cell size = 1 / (x - x)"); });
  show_refusal([] { generate("set Cell size = sqrt(x - 0.5)"); });
  show_refusal(
      [] { generate("set Cell size = abs(x - 0.123456789) + 1e-200"); });
}

const RoomTest test("voronoi_gradation", run);
} // namespace test_voronoi_gradation
