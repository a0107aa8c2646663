// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_plot_frame_h
#define voussoir_output_report_plot_frame_h

#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** What one axis of a plot shows. */
struct PlotRange
{
  std::string name;
  double low;  /**< finite */
  double high; /**< finite, not less */
  /** True for a logarithmic axis, with both ends positive. */
  bool by_ratio = false;
  /** Words that stand at 0, 1, ... instead of numbers. */
  std::vector<std::string> texts = {};
};

/** From the values of an axis to places in the picture. */
class PlotAxis
{
public:
  /** @param from, to the places of its ends. */
  PlotAxis(const PlotRange &range, double from, double to);

  double place(double value) const;
  /** Round values on the axis, or all words by their numbers. */
  std::vector<double> ticks() const;

private:
  double scaled(double value) const;

  const bool by_ratio;
  const std::size_t n_texts;
  const double from, to;
  double low, high;
};

/** The axes of a plot with what is drawn in them, as SVG. */
class PlotFrame
{
public:
  PlotFrame(const PlotRange &x, const PlotRange &y);

  /** @{ */
  /** The place of a value, in the units of the picture. */
  double x(double value) const { return of_x.place(value); }
  double y(double value) const { return of_y.place(value); }
  /** @} */
  /** The place of the axis of x. */
  double floor() const;

  /** Draw a line through places; @p kind is its class of the style sheet. */
  void path(const std::string &kind,
            const std::vector<std::pair<double, double>> &places);
  /** Add an element. */
  void add(const std::string &element) { content += element; }

  /** All of it. */
  std::string svg() const;

private:
  void
  words(double x, double y, const std::string &kind, const std::string &what);
  void add_grid(const PlotRange &x, const PlotRange &y);
  void add_text_below(double x, const std::string &whole);

  /** True if words below the axis stand aslant. */
  const bool is_aslant;
  /** What words below the axis take, beyond a line of numbers. */
  const double below;
  /** The place where the axis of x begins. */
  const double left;
  const PlotAxis of_x, of_y;
  const bool has_texts;
  std::string content;
};

/**
 * Round numbers within [low, high], about @p n of them; only @p low if both are
 * the same but for rounding.
 */
std::vector<double> ticks_of(double low, double high, unsigned int n);
} // namespace Voussoir

#endif
