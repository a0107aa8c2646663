// SPDX-License-Identifier: LGPL-2.1-or-later

// The ticks of an axis are round, equally far apart and within it.

#include <voussoir/output/report/plot.h>

#include "tests.h"

namespace test_plot
{
using namespace Voussoir;

void run()
{
  check("ticks", ticks_of(0., 1., 5) ==
                     std::vector<double>({0., 0.2, 0.4, 3 * 0.2, 0.8, 1.}));
  check("about zero",
        ticks_of(-1., 1., 4) == std::vector<double>({-1., -0.5, 0., 0.5, 1.}));
  bool are_round = true;
  for (const double low : {-3.7e5, 0.12, 1e-9, -2.})
    for (const double size : {1e-6, 0.37, 1., 8e7})
    {
      const std::vector<double> ticks = ticks_of(low, low + size, 6);
      const double step = ticks.at(1) - ticks.at(0);
      are_round = are_round && ticks.size() >= 3 && ticks.size() <= 8 &&
                  ticks.front() >= low - 1e-6 * size &&
                  ticks.back() <= low + size * (1. + 1e-6);
      // 1, 2 or 5 times a power of ten.
      const double mantissa =
          step / std::pow(10., std::floor(std::log10(step * (1. + 1e-6))));
      are_round = are_round && (std::abs(mantissa - 1.) < 1e-3 ||
                                std::abs(mantissa - 2.) < 1e-3 ||
                                std::abs(mantissa - 5.) < 1e-3);
    }
  check("round ones", are_round);

  const std::string one = plot_svg("x", "y", {{2., 3., "carried"}}, true);
  check("a single point is drawn", one.find("<circle") != std::string::npos &&
                                       one.find("nan") == std::string::npos &&
                                       one.find("inf") == std::string::npos);
  const double above = std::nextafter(1., 2.);
  check("no more than a tick where there is but rounding",
        ticks_of(1., above, 6).size() == 1 && ticks_of(0., 0., 6).size() == 1);
  const std::string same =
      plot_svg("x", "y", {{1., 1., "carried"}, {2., above, "carried"}}, false);
  check("values that differ by rounding are level",
        same.size() < 5000 && same.find("nan") == std::string::npos);
  const std::string two = plot_svg(
      "a < b", "y", {{1., 0., "carried"}, {100., 0., "collapse"}}, true);
  check("a level line", two.find("nan") == std::string::npos &&
                            two.find("a &lt; b") != std::string::npos);
}

const RoomTest test("plot", run);
} // namespace test_plot
