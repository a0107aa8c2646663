// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_plot_h
#define voussoir_output_report_plot_h

#include <string>
#include <vector>

namespace Voussoir
{
/** A point of a plot. */
struct PlotPoint
{
  double x; /**< finite */
  double y; /**< finite */
  /** How it is drawn: a class of the style sheet. */
  std::string kind;
};

/**
 * A plot of points, joined by a line where they follow each other, as SVG.
 *
 * @param x_name under the axis.
 * @param y_name above it.
 * @param points by ascending x.
 * @param by_ratio true for a logarithmic axis of x, all of them positive.
 */
std::string plot_svg(const std::string &x_name,
                     const std::string &y_name,
                     const std::vector<PlotPoint> &points,
                     bool by_ratio);
} // namespace Voussoir

#endif
