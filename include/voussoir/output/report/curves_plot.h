// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_curves_plot_h
#define voussoir_output_report_curves_plot_h

#include <voussoir/output/report/plot.h>
#include <voussoir/output/report/plot_frame.h>

#include <optional>
#include <string>
#include <vector>

namespace Voussoir
{
/** Points that belong together, by ascending x. */
struct PlotCurve
{
  /** Its words in the legend; may be empty if it is the only one. */
  std::string label;
  /** Those that follow each other without a gap. */
  std::vector<std::vector<PlotPoint>> parts;
};

/** A value of x without a number, marked on the axis. */
struct PlotMark
{
  double x;
  /** A class of the style sheet. */
  std::string kind;
  /** What it says if it is pointed at. */
  std::string words;
};

/** Several curves over one quantity. */
struct CurvesPlot
{
  /** The axis of x, whose ends are given. */
  PlotRange x;
  /** Above the axis of y. */
  std::string y_name;
  /** True for a logarithmic axis of y, all of them positive. */
  bool y_by_ratio;
  /** The curves, at most most_curves_in_plot, with some point in all. */
  std::vector<PlotCurve> curves;
  /** Drawn strong, beneath the curves. */
  std::vector<PlotCurve> envelopes = {};
  /** One that stands out, with a ring. */
  std::optional<PlotPoint> extreme = {};
  std::vector<PlotMark> marks = {};
};

/** The number of curves that can be told apart. */
constexpr std::size_t most_curves_in_plot = 12;

/**
 * The plot as SVG. Points of a single curve have the colours of their kinds;
 * with several, each curve has its own. Curves over words have no lines.
 */
std::string curves_svg(const CurvesPlot &plot);

/** What tells several curves and their envelope apart, as HTML. */
std::string curves_key(const CurvesPlot &plot);
} // namespace Voussoir

#endif
