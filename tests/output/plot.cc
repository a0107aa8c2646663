// SPDX-License-Identifier: LGPL-2.1-or-later

// The ticks of an axis are round, equally far apart and within it; curves have
// gaps and words below; the fields of a map reach half way to their neighbours.

#include <voussoir/output/report/curves_plot.h>
#include <voussoir/output/report/map_plot.h>
#include <voussoir/output/report/plot.h>
#include <voussoir/output/report/plot_frame.h>

#include "tests.h"
#include <iterator>
#include <regex>

namespace test_plot
{
using namespace Voussoir;

bool has(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

std::size_t count(const std::string &text, const std::string &what)
{
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; ++at)
    ++n;
  return n;
}

/** Two curves, of which one has a gap, and words instead of numbers. */
void check_curves()
{
  CurvesPlot plot = {{"x", 1., 3.},
                     "y",
                     true,
                     {{"a < b", {{{1., 1., "carried"}, {2., 10., "carried"}}}},
                      {"c", {{{1., 100., "carried"}}, {{3., 1., "carried"}}}}}};
  const std::string svg = curves_svg(plot);
  check("a gap is no line",
        count(svg, "path class=\"curve") == 1 && count(svg, "<circle") == 4);
  // By ratio the root of both ends is in their middle.
  const double middle = PlotAxis({"", 1., 100., true}, 250., 30.).place(10.);
  check("by ratio", std::abs(middle - 140.) < 1e-9 &&
                        has(svg, "<title>a &lt; b, x = 2: 10</title>") &&
                        has(svg, "cy=\"140\""));
  check("ticks of a short axis by ratio",
        PlotAxis({"", 0.6, 0.9, true}, 250., 30.).ticks().size() >= 3);
  check("a key for each", count(curves_key(plot), "<li>") == 2);
  plot.x = {"x", 0., 0., false, {"one", "two & more", "three"}};
  for (PlotCurve &curve : plot.curves)
    for (auto &part : curve.parts)
      for (PlotPoint &point : part)
        point.x -= 1.;
  const std::string over_words = curves_svg(plot);
  check("words below", has(over_words, ">two &amp; more</text>") &&
                           !has(over_words, "path class=\"curve") &&
                           !has(over_words, "rotate"));
  plot.x.texts[1] = std::string(24, 'm') + "\u00e9" + std::string(40, 'm');
  const std::string aslant = curves_svg(plot);
  check("long ones aslant and cut, between letters",
        has(aslant, '>' + std::string(24, 'm') + "\u2026<title>" +
                        plot.x.texts[1] + "</title>") &&
            count(aslant, "rotate") == 3);
}

/** Fields reach half way to their neighbours, by ratio too. */
void check_map()
{
  MapPlot plot = {{1., 10.}, {0., 1., 2.}, "x", "y", true, false, {}};
  for (unsigned int j = 0; j < 3; ++j)
    plot.fields.push_back(
        {{double(j), "", j > 0, "left"}, {{}, "collapse", false, "right"}});
  const std::string svg = map_svg(plot);
  // From 10^-1/2 to 10^3/2, and from -1/2 to 5/2: halves and thirds.
  const std::string left = "fill=\"#[0-9a-f]{6}\" x=\"80\"",
                    right = "class=\"field collapse\" x=\"350\"",
                    size = " y=\"[0-9.]+\" width=\"270\" height=\"73.3333\"";
  const auto fields = [&](const std::string &place) {
    const std::regex field("<rect [^>]*" + place + size);
    return std::distance(std::sregex_iterator(svg.begin(), svg.end(), field),
                         std::sregex_iterator());
  };
  check("half way",
        fields(left) == 3 && fields(right) == 3 && count(svg, "<rect ") == 6);
  // Two fields are carried on the left, one below is not.
  check("the contour", count(svg, "path class=\"contour\"") == 3);
  check("numbers have colours, and others their kinds",
        count(svg, "class=\"field collapse\"") == 3 &&
            count(svg, "fill=\"#") == 3 &&
            has(map_key(plot, "z"), "<span>0</span><span>2</span>"));
}

void run()
{
  check_curves();
  check_map();
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
