// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/plot.h>
#include <voussoir/output/report/plot_frame.h>

#include <algorithm>

namespace Voussoir
{
namespace
{
/** The radius of a point, in the units of the picture. */
constexpr double radius = 3.5;
} // namespace

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
  PlotFrame frame({x_name, points.front().x, points.back().x, by_ratio},
                  {y_name, least->y, most->y});
  for (std::size_t k = 1; k < points.size(); ++k)
    frame.path("curve", {{frame.x(points[k - 1].x), frame.y(points[k - 1].y)},
                         {frame.x(points[k].x), frame.y(points[k].y)}});
  for (const PlotPoint &point : points)
    frame.add(text("<circle class=\"", point.kind, "\" cx=\"", frame.x(point.x),
                   "\" cy=\"", frame.y(point.y), "\" r=\"", radius,
                   "\"><title>",
                   x_name.empty() ? "" : html_text(x_name) + " = ", point.x,
                   ": ", point.y, "</title></circle>\n"));
  return frame.svg();
}
} // namespace Voussoir
