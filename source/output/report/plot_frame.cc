// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/plot_frame.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/** The size of a plot and its margins, in units of its own. */
constexpr double plot_width = 640., plot_height = 300., least_left = 80.,
                 right = 20., top = 30., bottom = 50.;

/** The numbers beside an axis. */
constexpr unsigned int n_ticks = 6;

/** The width of a letter of the style sheet's size, in the same units. */
constexpr double letter = 6.8;

/** Words below an axis: the letters that are shown, and how they slope. */
constexpr std::size_t most_letters_below = 26;
constexpr double degrees_below = 32.;
const double cosine_below = std::cos(degrees_below * M_PI / 180.);
const double sine_below = std::sin(degrees_below * M_PI / 180.);

/** The number of letters that the longest of some words shows. */
double longest(const std::vector<std::string> &texts)
{
  std::size_t n = 0;
  for (const std::string &words : texts)
    n = std::max(n, words.size());
  return std::min(n, most_letters_below);
}

/** The part of the axis that each of some words has. */
double part_of_each(const std::vector<std::string> &texts)
{
  return (plot_width - right - least_left) / std::max<double>(1, texts.size());
}

/** True if words would meet if they stood level. */
bool stands_aslant(const std::vector<std::string> &texts)
{
  return (longest(texts) + 2.) * letter > part_of_each(texts);
}

/** Words of which no more than most_letters_below are shown. */
std::string cut(const std::string &whole)
{
  if (whole.size() <= most_letters_below)
    return whole;
  std::size_t n = most_letters_below - 1;
  while (n > 0 && (whole[n] & 0xC0) == 0x80) // within a letter of UTF-8
    --n;
  return whole.substr(0, n) + "\u2026";
}
} // namespace

PlotAxis::PlotAxis(const PlotRange &range, const double from, const double to)
    : by_ratio(range.by_ratio), n_texts(range.texts.size()), from(from), to(to)
{
  const double first = n_texts > 0 ? -0.5 : range.low;
  const double last = n_texts > 0 ? n_texts - 0.5 : range.high;
  // A single value is in the middle; what differs by rounding is one.
  const double size = std::max(std::abs(first), std::abs(last));
  const double around = last - first > 1e-9 * size ? 0.
                        : size > 0.                ? 0.5 * size
                                                   : 0.5;
  low = scaled(by_ratio && around > 0. ? 0.5 * first : first - around);
  high = scaled(by_ratio && around > 0. ? 2. * last : last + around);
}

double PlotAxis::scaled(const double value) const
{
  return by_ratio ? std::log10(value) : value;
}

double PlotAxis::place(const double value) const
{
  return from + (scaled(value) - low) / (high - low) * (to - from);
}

std::vector<double> PlotAxis::ticks() const
{
  std::vector<double> values;
  for (std::size_t k = 0; k < n_texts; ++k)
    values.push_back(k);
  if (n_texts > 0)
    return values;
  if (!by_ratio)
    return ticks_of(low, high, n_ticks);
  // 1, 2 and 5 times powers of ten, or these alone if they are many.
  const std::vector<double> of_power = high - low > n_ticks / 2.
                                           ? std::vector<double>{1.}
                                           : std::vector<double>{1., 2., 5.};
  for (double power = std::floor(low); power <= high; ++power)
    for (const double of : of_power)
    {
      const double value = of * std::pow(10., power);
      if (scaled(value) > low - 1e-9 && scaled(value) < high + 1e-9)
        values.push_back(value);
    }
  // Of less than a step of these there are those of a linear axis.
  return values.size() < 2
             ? ticks_of(std::pow(10., low), std::pow(10., high), n_ticks)
             : values;
}

PlotFrame::PlotFrame(const PlotRange &x, const PlotRange &y)
    : is_aslant(stands_aslant(x.texts)),
      below(is_aslant ? longest(x.texts) * letter * sine_below : 0.),
      left(is_aslant ? std::max(least_left,
                                longest(x.texts) * letter * cosine_below -
                                    0.5 * part_of_each(x.texts))
                     : least_left),
      of_x(x, left, plot_width - right), of_y(y, plot_height - bottom, top),
      has_texts(!x.texts.empty())
{
  add_grid(x, y);
}

double PlotFrame::floor() const
{
  return plot_height - bottom;
}

void PlotFrame::path(const std::string &kind,
                     const std::vector<std::pair<double, double>> &places)
{
  content += "<path class=\"" + kind + "\" d=\"";
  for (std::size_t k = 0; k < places.size(); ++k)
    content += text(k == 0 ? 'M' : 'L', places[k].first, ' ', places[k].second);
  content += "\"/>\n";
}

void PlotFrame::words(const double at_x,
                      const double at_y,
                      const std::string &kind,
                      const std::string &what)
{
  content += text("<text class=\"", kind, "\" x=\"", at_x, "\" y=\"", at_y,
                  "\">", html_text(what), "</text>\n");
}

void PlotFrame::add_text_below(const double at_x, const std::string &whole)
{
  const double at_y = floor() + 16.;
  if (!is_aslant)
    return words(at_x, at_y, "below", whole);
  const double x = at_x + 4.;
  content += text("<text class=\"beside\" x=\"", x, "\" y=\"", at_y,
                  "\" transform=\"rotate(", -degrees_below, ' ', x, ' ', at_y,
                  ")\">", html_text(cut(whole)), "<title>", html_text(whole),
                  "</title></text>\n");
}

void PlotFrame::add_grid(const PlotRange &x_range, const PlotRange &y_range)
{
  for (const double value : of_x.ticks())
  {
    path("grid", {{x(value), top}, {x(value), floor()}});
    if (has_texts)
      add_text_below(x(value), x_range.texts[value]);
    else
      words(x(value), floor() + 16., "below", text(value));
  }
  for (const double value : of_y.ticks())
  {
    path("grid", {{left, y(value)}, {plot_width - right, y(value)}});
    words(left - 6., y(value) + 4., "beside", text(value));
  }
  words(0.5 * (left + plot_width - right), plot_height + below - 8., "below",
        x_range.name);
  words(left, top - 12., "above", y_range.name);
}

std::string PlotFrame::svg() const
{
  return text("<svg class=\"plot", has_texts ? " of-texts" : "",
              "\" viewBox=\"0 0 ", plot_width, ' ', plot_height + below,
              "\" role=\"img\">\n") +
         content + "</svg>\n";
}

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
} // namespace Voussoir
