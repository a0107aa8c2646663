// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/colour_scale.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace Voussoir
{
namespace
{
using Colour = std::array<double, 3>;

/** A value, over the largest, that is no sign of its own. */
constexpr double rounding_of_values = 1e-9;

/** From nothing to the largest size; ever darker. */
const std::vector<Colour> sequential = {{{243, 230, 190}},
                                        {{232, 176, 92}},
                                        {{201, 103, 52}},
                                        {{140, 46, 72}},
                                        {{52, 18, 72}}};

/** From the most negative to the most positive. */
const std::vector<Colour> diverging = {{{24, 62, 130}},
                                       {{120, 160, 210}},
                                       {{226, 226, 226}},
                                       {{232, 160, 88}},
                                       {{158, 70, 6}}};

std::string hexadecimal(const std::vector<Colour> &anchors, const double share)
{
  const double place = share * (anchors.size() - 1);
  const std::size_t k = std::min<std::size_t>(place, anchors.size() - 2);
  std::string colour = "#";
  for (unsigned int d = 0; d < 3; ++d)
  {
    char digits[3];
    std::snprintf(digits, sizeof(digits), "%02x",
                  static_cast<unsigned int>(std::lround(
                      anchors[k][d] +
                      (place - k) * (anchors[k + 1][d] - anchors[k][d]))));
    colour += digits;
  }
  return colour;
}
} // namespace

ColourScale::ColourScale(std::string name, const std::vector<double> &values)
    : name(std::move(name))
{
  for (const double value : values)
    if (std::isfinite(value))
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
    else
      has_missing = true;
  if (-low <= rounding_of_values * high)
    low = 0.;
  if (high <= -rounding_of_values * low)
    high = 0.;
  // Zero is in the middle, so that a colour tells the sign.
  if (has_both_signs())
  {
    high = std::max(high, -low);
    low = -high;
  }
}

ColourScale::ColourScale(std::string name, const double most)
    : name(std::move(name)), high(most)
{}

double ColourScale::share(const double value) const
{
  const double largest = std::max(high, -low);
  return std::isfinite(value) && largest > 0.
             ? std::min(1., std::abs(value) / largest)
             : 0.;
}

unsigned int ColourScale::step(const double value) const
{
  if (high == low)
    return 0;
  const double at =
      has_both_signs() ? (value - low) / (high - low) : share(value);
  return std::lround(std::clamp(at, 0., 1.) * (n_steps - 1));
}

double ColourScale::middle(const double step) const
{
  const double at = step / (n_steps - 1);
  if (has_both_signs())
    return low + at * (high - low);
  return 0. + at * (high > 0. ? high : low); // no -0
}

std::string ColourScale::class_of(const double value) const
{
  return name + (std::isfinite(value) ? std::to_string(step(value)) : "none");
}

std::vector<std::string> ColourScale::colours() const
{
  const auto &anchors = has_both_signs() ? diverging : sequential;
  std::vector<std::string> all;
  for (unsigned int k = 0; k < n_steps; ++k)
    all.push_back(hexadecimal(anchors, double(k) / (n_steps - 1)));
  return all;
}

std::string ColourScale::rules(const std::string &selector) const
{
  std::string css;
  const std::vector<std::string> all = colours();
  for (unsigned int k = 0; k < n_steps; ++k)
    css += text(selector, " .", name, k, "{--colour:", all[k],
                ";--share:", share(middle(k)), "}\n");
  return css + text(selector, " .", name,
                    "none{--colour:var(--missing);--share:1}\n");
}

std::string ColourScale::legend(const std::string &title) const
{
  std::string html = "<p>" + html_text(title) + "</p>";
  if (high > low)
  {
    const auto &anchors = has_both_signs() ? diverging : sequential;
    std::string stops;
    for (const Colour &anchor : anchors)
      stops += text(stops.empty() ? "" : ",", "rgb(", anchor[0], ' ', anchor[1],
                    ' ', anchor[2], ')');
    html += text("<div class=\"bar\" style=\"background:linear-gradient(to "
                 "right,",
                 stops, ")\"></div><div class=\"ends\"><span>", middle(0),
                 "</span><span>", middle(0.5 * (n_steps - 1)), "</span><span>",
                 middle(n_steps - 1), "</span></div>");
  }
  else
    html += "<p>zero everywhere</p>";
  if (has_missing)
    html += "<p><span class=\"swatch missing\"></span> without bound, or not "
            "asked for</p>";
  return html;
}

std::string html_text(const std::string &text)
{
  std::string html;
  for (const char letter : text)
    switch (letter)
    {
    case '&': html += "&amp;"; break;
    case '<': html += "&lt;"; break;
    case '>': html += "&gt;"; break;
    case '"': html += "&quot;"; break;
    default: html += letter;
    }
  return html;
}
} // namespace Voussoir
