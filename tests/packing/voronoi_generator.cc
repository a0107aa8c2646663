// SPDX-License-Identifier: LGPL-2.1-or-later

// The generator of Voronoi packings: the seed decides, Lloyd steps make the
// cells alike, scaling the rectangle scales the packing; failures.

#include <voussoir/packing/voronoi/voronoi.h>

#include "tests.h"
#include <fstream>

namespace test_voronoi_generator
{
using namespace Voussoir;

Packing<2> generate(const std::string &settings)
{
  VoronoiGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.parse_input_from_string(settings);
  return Packing<2>(generator.generate(".", Terminal::silent()));
}

/** Standard deviation of the areas over their mean. */
double spread(const Packing<2> &packing)
{
  const double mean = packing.area() / packing.n_cells();
  double variance = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    variance += std::pow(packing.area(c) / mean - 1., 2) / packing.n_cells();
  return std::sqrt(variance);
}

void run()
{
  const std::string number = "set Number of points = 400\n";
  const Packing<2> first = generate(number + "set Seed = 5");
  const Packing<2> second = generate(number + "set Seed = 5");
  const Packing<2> other = generate(number + "set Seed = 6");
  double same = 0., different = 0.;
  for (unsigned int c = 0; c < 400; ++c)
  {
    same = std::max(same, first.centre(c).distance(second.centre(c)));
    different = std::max(different, first.centre(c).distance(other.centre(c)));
  }
  check_error("same seed, same points", same, 0.);
  check("another seed, other points", different > 0.1);

  // Areas of Voronoi cells of random points spread by 0.53 of their mean.
  check("spread of random cells", std::abs(spread(first) - 0.53) < 0.05);
  check("fifty Lloyd steps leave less than a third of that",
        spread(generate(number + "set Lloyd steps = 50")) < 0.53 / 3);

  const Packing<2> large =
      generate(number + "set Seed = 5\nset Lower left = 1000, 0\n"
                        "set Upper right = 3000, 2000");
  double error = 0.;
  for (unsigned int c = 0; c < 400; ++c)
    error = std::max(error, std::abs(large.area(c) / first.area(c) / 4e6 - 1.));
  check_error("twice as large in thousands, shifted", error, 1e-9);

  show_refusal([] { generate("set Points = file"); });
  show_refusal([] { generate("set Upper right = 1, 0"); });
  show_refusal([] {
    generate("set Points = file\nset Points file = no_such_file.txt");
  });
  std::ofstream("outside.txt") << "# two points\n0.5 0.5\n\n1.5 0.5\n";
  show_refusal(
      [] { generate("set Points = file\nset Points file = outside.txt"); });
  std::ofstream("on_the_side.txt") << "0.5 1\n";
  show_refusal(
      [] { generate("set Points = file\nset Points file = on_the_side.txt"); });
  std::ofstream("twice.txt") << "0.5 0.5\n0.25 0.5\n0.5 0.5\n";
  show_refusal(
      [] { generate("set Points = file\nset Points file = twice.txt"); });
  std::ofstream("close.txt")
      << "0.5 0.5\n0.25 0.5\n0.25 0.50000000000000001e0\n"
         "0.5 0.50000000000000011\n";
  show_refusal(
      [] { generate("set Points = file\nset Points file = close.txt"); });
}

const RoomTest test("voronoi_generator", run);
} // namespace test_voronoi_generator
