// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/plot.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** The size of a plot and its margins, in units of its own. */
constexpr double width = 640., height = 300., left = 80., right = 20.,
                 top = 30., bottom = 50.;

/** The numbers beside an axis. */
constexpr unsigned int n_ticks = 6;

/** The radius of a point, in the same. */
constexpr double radius = 3.5;

/** One of the two axes: from values to places. */
class Axis
{
public:
  Axis(double low,
       double high,
       const double from,
       const double to,
       const bool by_ratio)
      : by_ratio(by_ratio), from(from), to(to)
  {
    // A single value is in the middle; what differs by rounding is one.
    const double size = std::max(std::abs(low), std::abs(high));
    const double around = high - low > 1e-9 * size ? 0.
                          : size > 0.              ? 0.5 * size
                                                   : 0.5;
    this->low = scaled(by_ratio && around > 0. ? 0.5 * low : low - around);
    this->high = scaled(by_ratio && around > 0. ? 2. * high : high + around);
  }

  double place(const double value) const
  {
    return from + (scaled(value) - low) / (high - low) * (to - from);
  }

  std::vector<double> ticks() const
  {
    if (!by_ratio)
      return ticks_of(low, high, n_ticks);
    // 1, 2 and 5 times powers of ten, or these alone if they are many.
    const std::vector<double> of_power = high - low > n_ticks / 2.
                                             ? std::vector<double>{1.}
                                             : std::vector<double>{1., 2., 5.};
    std::vector<double> values;
    for (double power = std::floor(low); power <= high; ++power)
      for (const double of : of_power)
      {
        const double value = of * std::pow(10., power);
        if (scaled(value) > low - 1e-9 && scaled(value) < high + 1e-9)
          values.push_back(value);
      }
    return values;
  }

private:
  double scaled(const double value) const
  {
    return by_ratio ? std::log10(value) : value;
  }

  const bool by_ratio;
  const double from, to;
  double low, high;
};
} // namespace

std::vector<double>
ticks_of(const double low, const double high, const unsigned int n)
{
  const double raw = (high - low) / n;
  if (!(raw > 1e-14 * std::max(std::abs(low), std::abs(high))))
    return {low};
  const double power = std::pow(10., std::floor(std::log10(raw)));
  double step = 10. * power;
  for (const double of : {1., 2., 5.})
    if (of * power >= raw)
    {
      step = of * power;
      break;
    }
  std::vector<double> ticks;
  // Whole numbers of steps, so that zero is zero.
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step;
       ++k)
    ticks.push_back(k == 0. ? 0. : k * step);
  return ticks;
}

std::string plot_svg(const std::string &x_name,
                     const std::string &y_name,
                     const std::vector<PlotPoint> &points,
                     const bool by_ratio)
{
  const auto by_y = [](const PlotPoint &a, const PlotPoint &b) {
    return a.y < b.y;
  };
  const auto [least, most] =
      std::minmax_element(points.begin(), points.end(), by_y);
  const Axis x(points.front().x, points.back().x, left, width - right,
               by_ratio);
  const Axis y(least->y, most->y, height - bottom, top, false);

  std::string svg = text("<svg class=\"plot\" viewBox=\"0 0 ", width, ' ',
                         height, "\" role=\"img\">\n");
  const auto line = [&](const double x0, const double y0, const double x1,
                        const double y1, const char *kind) {
    svg += text("<path class=\"", kind, "\" d=\"M", x0, ' ', y0, 'L', x1, ' ',
                y1, "\"/>\n");
  };
  const auto words = [&](const double at_x, const double at_y, const char *kind,
                         const std::string &what) {
    svg += text("<text class=\"", kind, "\" x=\"", at_x, "\" y=\"", at_y, "\">",
                html_text(what), "</text>\n");
  };
  for (const double value : x.ticks())
  {
    line(x.place(value), top, x.place(value), height - bottom, "grid");
    words(x.place(value), height - bottom + 16., "below", text(value));
  }
  for (const double value : y.ticks())
  {
    line(left, y.place(value), width - right, y.place(value), "grid");
    words(left - 6., y.place(value) + 4., "beside", text(value));
  }
  words(0.5 * (left + width - right), height - 8., "below", x_name);
  words(left, top - 12., "above", y_name);
  for (std::size_t k = 1; k < points.size(); ++k)
    line(x.place(points[k - 1].x), y.place(points[k - 1].y),
         x.place(points[k].x), y.place(points[k].y), "curve");
  for (const PlotPoint &point : points)
    svg += text("<circle class=\"", point.kind, "\" cx=\"", x.place(point.x),
                "\" cy=\"", y.place(point.y), "\" r=\"", radius, "\"><title>",
                x_name.empty() ? "" : html_text(x_name) + " = ", point.x, ": ",
                point.y, "</title></circle>\n");
  return svg + "</svg>\n";
}
} // namespace Voussoir
