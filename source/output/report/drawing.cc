// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/drawing.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace Voussoir
{
namespace
{
/** The width or height of the picture, in units of its own. */
constexpr double picture_size = 1000.;

/** The margin around the packing, in the same. */
constexpr double margin = 60.;

/** The digits behind the point of a place in the picture. */
constexpr int n_digits = 2;

/** @{ */
/** The longest bar of the scale, and its place below the packing; units of the
 * picture. */
constexpr double longest_scale_bar = 130., scale_bar_below = 45.;
/** @} */

/** 1, 2 or 5 times a power of ten, the largest that is not above @p x. */
double round_below(const double x)
{
  const double power = std::pow(10., std::floor(std::log10(x)));
  return power * (x >= 5. * power ? 5. : x >= 2. * power ? 2. : 1.);
}
} // namespace

Drawing::Drawing(const Packing<2> &packing) : Drawing(packing.box()) {}

Drawing::Drawing(const dealii::BoundingBox<2> &box)
    : box(box), size(std::max(box.side_length(0), box.side_length(1)))
{}

std::string Drawing::view_box() const
{
  TextLines text;
  number(-margin, text);
  text << ' ';
  number(-margin, text);
  for (unsigned int d = 0; d < 2; ++d)
  {
    text << ' ';
    number(picture_size * (box.side_length(d) / size) + 2. * margin, text);
  }
  return text.text();
}

void Drawing::number(const double x, TextLines &text)
{
  char digits[std::numeric_limits<double>::max_exponent10 + 8];
  char *end = std::to_chars(digits, digits + sizeof(digits), x,
                            std::chars_format::fixed, n_digits)
                  .ptr;
  while (end[-1] == '0')
    --end;
  if (end[-1] == '.')
    --end;
  const std::string_view written(digits, end - digits);
  text << (written == "-0" ? std::string_view("0") : written);
}

void Drawing::place(const dealii::Point<2> &p,
                    const char between,
                    TextLines &text) const
{
  number(picture_size * ((p[0] - box.lower_bound(0)) / size), text);
  text << between;
  number(picture_size * ((box.upper_bound(1) - p[1]) / size), text);
}

void Drawing::open(const std::string &attributes)
{
  content << "<g " << attributes << ">\n";
}

void Drawing::close()
{
  content << "</g>\n";
}

void Drawing::end_with(const std::string &classes,
                       const std::string &attributes)
{
  if (!classes.empty())
    content << " class=\"" << classes << '"';
  if (!attributes.empty())
    content << ' ' << attributes;
  content << "/>\n";
  drawn.insert(classes);
}

void Drawing::many(const char *element,
                   const std::vector<dealii::Point<2>> &points,
                   const std::string &classes)
{
  content << '<' << element << " points=\"";
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (i > 0)
      content << ' ';
    place(points[i], ',', content);
  }
  content << '"';
  end_with(classes);
}

void Drawing::polygon(const std::vector<dealii::Point<2>> &corners,
                      const std::string &classes)
{
  many("polygon", corners, classes);
}

void Drawing::polyline(const std::vector<dealii::Point<2>> &points,
                       const std::string &classes)
{
  many("polyline", points, classes);
}

void Drawing::line(const dealii::Point<2> &from,
                   const dealii::Point<2> &to,
                   const std::string &classes,
                   const std::string &attributes)
{
  content << "<path d=\"M";
  place(from, ' ', content);
  content << 'L';
  place(to, ' ', content);
  content << '"';
  end_with(classes, attributes);
}

void Drawing::add_to_path(const std::vector<dealii::Point<2>> &points,
                          const bool is_closed,
                          const std::string &classes)
{
  TextLines &path = paths[classes];
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    path << (i == 0 ? 'M' : 'L');
    place(points[i], ' ', path);
  }
  if (is_closed)
    path << 'z';
}

void Drawing::finish_paths()
{
  for (const auto &[classes, path] : paths)
  {
    content << "<path d=\"" << path.text() << '"';
    end_with(classes);
  }
  paths.clear();
}

void Drawing::dot(const dealii::Point<2> &p,
                  const std::string &classes,
                  const std::string &attributes)
{
  // A line without length has round ends that keep their size when zoomed.
  line(p, p, classes, attributes);
}

void Drawing::append(const Drawing &other)
{
  content << other.elements();
  drawn.insert(other.drawn.begin(), other.drawn.end());
}

double Drawing::length_of_unit() const
{
  return size / picture_size;
}

void Drawing::scale_bar(const std::string &unit)
{
  const double length = round_below(longest_scale_bar / picture_size * size);
  const dealii::Point<2> start(box.lower_bound(0),
                               box.lower_bound(1) -
                                   scale_bar_below / picture_size * size);
  const dealii::Point<2> end(start[0] + length, start[1]);
  open("id=\"scale\"");
  line(start, end, "");
  content << "<text font-size=\"20\" dx=\"8\" dy=\"7\" x=\"";
  number(picture_size * ((end[0] - box.lower_bound(0)) / size), content);
  content << "\" y=\"";
  number(picture_size * ((box.upper_bound(1) - end[1]) / size), content);
  content << "\">" << html_text(text(length, unit.empty() ? "" : " ", unit))
          << "</text>\n";
  close();
}

bool Drawing::has(const std::string &words, const std::string &without) const
{
  const auto is_in = [](const std::string &classes, const std::string &one) {
    return (' ' + classes + ' ').find(' ' + one + ' ') != std::string::npos;
  };
  return std::any_of(drawn.begin(), drawn.end(), [&](const auto &classes) {
    return is_in(classes, words) &&
           (without.empty() || !is_in(classes, without));
  });
}
} // namespace Voussoir
