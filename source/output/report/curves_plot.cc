// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/curves_plot.h>

#include <algorithm>
#include <limits>

namespace Voussoir
{
namespace
{
/** The colours of the style sheet; more curves have them again, dashed. */
constexpr std::size_t n_curve_colours = 6;

/** The radius of a point, of one of very many, and of the ring, in the units of
 * the picture. */
constexpr double radius_of_few = 3.5, radius_of_many = 2., radius_of_ring = 7.;

/** The points that are few. */
constexpr std::size_t most_points_of_few = 60;

/** Half a bar of an envelope over a word. */
constexpr double half_bar = 0.3;

/** Half the size of a mark. */
constexpr double half_mark = 4.;

/** The classes that tell a curve from others. */
std::string classes_of_curve(const std::size_t k)
{
  return text("tinted c", k % n_curve_colours,
              k >= n_curve_colours ? " dashed" : "");
}

PlotRange range_of_y(const CurvesPlot &plot)
{
  PlotRange range = {plot.y_name, std::numeric_limits<double>::max(),
                     std::numeric_limits<double>::lowest(), plot.y_by_ratio};
  for (const PlotCurve &curve : plot.curves)
    for (const auto &part : curve.parts)
      for (const PlotPoint &point : part)
      {
        range.low = std::min(range.low, point.y);
        range.high = std::max(range.high, point.y);
      }
  return range;
}

std::size_t n_points(const CurvesPlot &plot)
{
  std::size_t n = 0;
  for (const PlotCurve &curve : plot.curves)
    for (const auto &part : curve.parts)
      n += part.size();
  return n;
}

/** Draws the parts of a plot. */
class CurvesPicture
{
public:
  explicit CurvesPicture(const CurvesPlot &plot)
      : plot(plot), frame(plot.x, range_of_y(plot)),
        radius(n_points(plot) > most_points_of_few ? radius_of_many
                                                   : radius_of_few)
  {}

  void add_line(const PlotCurve &curve, const std::string &kind)
  {
    for (const auto &part : curve.parts)
    {
      std::vector<std::pair<double, double>> places;
      for (const PlotPoint &point : part)
        places.emplace_back(frame.x(point.x), frame.y(point.y));
      if (places.size() > 1)
        frame.path(kind, places);
    }
  }

  /** A bar at each point, for words, between which there is nothing. */
  void add_bars(const PlotCurve &curve, const std::string &kind)
  {
    for (const auto &part : curve.parts)
      for (const PlotPoint &point : part)
        frame.path(kind, {{frame.x(point.x - half_bar), frame.y(point.y)},
                          {frame.x(point.x + half_bar), frame.y(point.y)}});
  }

  /** Points in the colours of their kinds or, with a class, in its own. */
  void add_points(const PlotCurve &curve, const std::string &own)
  {
    for (const auto &part : curve.parts)
      for (const PlotPoint &point : part)
        frame.add(text("<circle class=\"", own.empty() ? point.kind : own,
                       "\" cx=\"", frame.x(point.x), "\" cy=\"",
                       frame.y(point.y), "\" r=\"", radius, "\"><title>",
                       html_text(words_of(curve, point)),
                       "</title></circle>\n"));
  }

  void add_mark(const PlotMark &mark)
  {
    const double x = frame.x(mark.x), y = frame.floor();
    frame.add(text("<path class=\"mark ", mark.kind, "\" d=\"M", x - half_mark,
                   ' ', y - half_mark, 'L', x + half_mark, ' ', y + half_mark,
                   'M', x - half_mark, ' ', y + half_mark, 'L', x + half_mark,
                   ' ', y - half_mark, "\"><title>", html_text(mark.words),
                   "</title></path>\n"));
  }

  void add_ring(const PlotPoint &point)
  {
    frame.add(text("<circle class=\"ring\" cx=\"", frame.x(point.x), "\" cy=\"",
                   frame.y(point.y), "\" r=\"", radius_of_ring, "\"/>\n"));
  }

  std::string svg() const { return frame.svg(); }

private:
  std::string words_of(const PlotCurve &curve, const PlotPoint &point) const
  {
    const auto &texts = plot.x.texts;
    return text(curve.label, curve.label.empty() ? "" : ", ", plot.x.name,
                " = ", texts.empty() ? text(point.x) : texts[point.x], ": ",
                point.y);
  }

  const CurvesPlot &plot;
  PlotFrame frame;
  const double radius;
};

std::string key_of(const std::string &kind, const std::string &label)
{
  return "<li><svg class=\"key\" viewBox=\"0 0 32 12\"><path class=\"" + kind +
         "\" d=\"M1 6L31 6\"/></svg> " + html_text(label) + "</li>\n";
}
} // namespace

std::string curves_svg(const CurvesPlot &plot)
{
  CurvesPicture picture(plot);
  const bool has_words = !plot.x.texts.empty();
  for (const PlotCurve &envelope : plot.envelopes)
    if (has_words)
      picture.add_bars(envelope, "envelope");
    else
      picture.add_line(envelope, "envelope");
  const bool has_one = plot.curves.size() == 1;
  for (std::size_t k = 0; k < plot.curves.size(); ++k)
    if (!has_words)
      picture.add_line(plot.curves[k],
                       has_one ? "curve" : "curve " + classes_of_curve(k));
  for (std::size_t k = 0; k < plot.curves.size(); ++k)
    picture.add_points(plot.curves[k], has_one ? "" : classes_of_curve(k));
  for (const PlotMark &mark : plot.marks)
    picture.add_mark(mark);
  if (plot.extreme)
    picture.add_ring(*plot.extreme);
  return picture.svg();
}

std::string curves_key(const CurvesPlot &plot)
{
  std::string html;
  if (plot.curves.size() > 1)
    for (std::size_t k = 0; k < plot.curves.size(); ++k)
      html += key_of("curve " + classes_of_curve(k), plot.curves[k].label);
  if (!plot.envelopes.empty())
    html += key_of("envelope", plot.envelopes.front().label);
  return html.empty() ? "" : "<ul class=\"keys\">\n" + html + "</ul>\n";
}
} // namespace Voussoir
