// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_map_plot_h
#define voussoir_output_report_map_plot_h

#include <voussoir/output/report/plot_frame.h>

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** A field of a map, around a pair of values. */
struct MapField
{
  /** The number that its colour shows, or none. */
  std::optional<double> number = {};
  /** A class of the style sheet for a field without a number. */
  std::string kind = {};
  /** Fields of different sides have the contour between them; none of others.
   */
  std::optional<bool> side = {};
  /** What it says if it is pointed at. */
  std::string words = {};
};

/** One quantity over two others. */
struct MapPlot
{
  /** @{ */
  /** The values along both axes, ascending and at least two. */
  std::vector<double> x, y;
  std::string x_name, y_name;
  bool x_by_ratio, y_by_ratio;
  /** @} */
  /** By the number of the value of y, and that of x. */
  std::vector<std::vector<MapField>> fields;
};

/** The map as SVG: a field reaches half way to its neighbours. */
std::string map_svg(const MapPlot &plot);

/** The colours of its numbers, under the title @p title, as HTML. */
std::string map_key(const MapPlot &plot, const std::string &title);
} // namespace Voussoir

#endif
