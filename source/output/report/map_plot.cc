// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/map_plot.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
/** Where the fields of ascending values begin and end, one more than these. */
std::vector<double> sides_of_fields(const std::vector<double> &values,
                                    const bool by_ratio)
{
  const auto between = [by_ratio](const double a, const double b) {
    return by_ratio ? std::sqrt(a * b) : 0.5 * (a + b);
  };
  const auto beyond = [by_ratio](const double end, const double side) {
    return by_ratio ? end * end / side : 2. * end - side;
  };
  std::vector<double> sides = {0.};
  for (std::size_t k = 1; k < values.size(); ++k)
    sides.push_back(between(values[k - 1], values[k]));
  sides.front() = beyond(values.front(), sides[1]);
  sides.push_back(beyond(values.back(), sides.back()));
  return sides;
}

/** The least and the greatest number of a map; zeros if it has none. */
std::pair<double, double> extent_of(const MapPlot &plot)
{
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (const auto &row : plot.fields)
    for (const MapField &field : row)
      if (field.number)
      {
        low = std::min(low, *field.number);
        high = std::max(high, *field.number);
      }
  return low > high ? std::pair(0., 0.) : std::pair(low, high);
}

/** From light to dark. */
std::vector<std::string> colours_of_map()
{
  return ColourScale("map", 1.).colours();
}

/** Draws the parts of a map. */
class MapPicture
{
public:
  explicit MapPicture(const MapPlot &plot)
      : plot(plot), x_sides(sides_of_fields(plot.x, plot.x_by_ratio)),
        y_sides(sides_of_fields(plot.y, plot.y_by_ratio)),
        frame({plot.x_name, x_sides.front(), x_sides.back(), plot.x_by_ratio},
              {plot.y_name, y_sides.front(), y_sides.back(), plot.y_by_ratio}),
        extent(extent_of(plot)), colours(colours_of_map())
  {}

  void add_fields()
  {
    for (std::size_t j = 0; j < plot.y.size(); ++j)
      for (std::size_t i = 0; i < plot.x.size(); ++i)
        add_field(i, j, plot.fields[j][i]);
  }

  /** Lines between fields of different sides. */
  void add_contour()
  {
    for (std::size_t j = 0; j < plot.y.size(); ++j)
      for (std::size_t i = 0; i < plot.x.size(); ++i)
      {
        if (i > 0 && differ(plot.fields[j][i - 1], plot.fields[j][i]))
          frame.path("contour", {{x(i), y(j)}, {x(i), y(j + 1)}});
        if (j > 0 && differ(plot.fields[j - 1][i], plot.fields[j][i]))
          frame.path("contour", {{x(i), y(j)}, {x(i + 1), y(j)}});
      }
  }

  std::string svg() const { return frame.svg(); }

private:
  double x(const std::size_t i) const { return frame.x(x_sides[i]); }
  double y(const std::size_t j) const { return frame.y(y_sides[j]); }

  static bool differ(const MapField &a, const MapField &b)
  {
    return a.side && b.side && *a.side != *b.side;
  }

  void
  add_field(const std::size_t i, const std::size_t j, const MapField &field)
  {
    if (!field.number && field.kind.empty())
      return;
    std::string how = "class=\"field " + field.kind + '"';
    if (field.number)
    {
      const auto [low, high] = extent;
      const double share =
          high > low ? (*field.number - low) / (high - low) : 0.5;
      how = "class=\"field\" fill=\"" +
            colours[std::lround(share * double(colours.size() - 1))] + '"';
    }
    frame.add(text("<rect ", how, " x=\"", x(i), "\" y=\"", y(j + 1),
                   "\" width=\"", x(i + 1) - x(i), "\" height=\"",
                   y(j) - y(j + 1), "\"><title>", html_text(field.words),
                   "</title></rect>\n"));
  }

  const MapPlot &plot;
  const std::vector<double> x_sides, y_sides;
  PlotFrame frame;
  const std::pair<double, double> extent;
  const std::vector<std::string> colours;
};
} // namespace

std::string map_svg(const MapPlot &plot)
{
  MapPicture picture(plot);
  picture.add_fields();
  picture.add_contour();
  return picture.svg();
}

std::string map_key(const MapPlot &plot, const std::string &title)
{
  const auto [low, high] = extent_of(plot);
  std::string stops;
  for (const std::string &colour : colours_of_map())
    stops += (stops.empty() ? "" : ",") + colour;
  return text("<div class=\"map-key\"><p>", html_text(title),
              "</p><div class=\"bar\" style=\"background:linear-gradient(to "
              "right,",
              stops, ")\"></div><div class=\"ends\"><span>", low,
              "</span><span>", high, "</span></div></div>\n");
}
} // namespace Voussoir
