// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/decimal_comma.h>
#include <voussoir/base/text.h>
#include <voussoir/base/text_file.h>
#include <voussoir/packing/polygons/points_file.h>

#include <boost/algorithm/string.hpp>
#include <boost/lexical_cast.hpp>

#include <cmath>
#include <optional>
#include <sstream>

namespace Voussoir
{
std::string PointList::describe(const unsigned int i) const
{
  std::string description = text("point ", i, " at ", text_of_point(points[i]));
  if (!lines.empty())
    description += text(" (line ", lines[i], " of '", file.string(), "')");
  return description;
}

namespace
{
std::optional<dealii::Point<2>> point_of(const std::string &content)
{
  std::vector<std::string> words;
  boost::split(words, content, boost::is_any_of(" \t,;"),
               boost::token_compress_on);
  dealii::Point<2> point;
  if (words.size() != 2 ||
      !boost::conversion::try_lexical_convert(words[0], point[0]) ||
      !boost::conversion::try_lexical_convert(words[1], point[1]) ||
      !std::isfinite(point[0]) || !std::isfinite(point[1]))
    return {};
  return point;
}
} // namespace

PointList read_points_file(const std::filesystem::path &file)
{
  const std::optional<std::string> all = read_text_file(file);
  if (!all)
    throw InputError("The points file '" + file.string() +
                     "' cannot be read. Paths in a .prm file start at the "
                     "directory of that file.");

  PointList list;
  list.file = file;
  std::istringstream in(*all);
  std::string line;
  for (unsigned int number = 1; std::getline(in, line); ++number)
  {
    const std::string content = boost::trim_copy_if(
        line.substr(0, line.find('#')), boost::is_any_of(" \t\r"));
    if (content.empty())
      continue;
    const std::optional<dealii::Point<2>> point = point_of(content);
    if (!point)
      throw InputError(text("Line ", number, " of the points file '",
                            file.string(), "' is '", content,
                            "'; two finite numbers \"x y\" are expected",
                            point_of(with_decimal_points(content))
                                ? advice_on_decimal_comma(content)
                                : "",
                            "."));
    list.points.push_back(*point);
    list.lines.push_back(number);
  }
  if (list.points.empty())
    throw InputError("The points file '" + file.string() +
                     "' has no points; a packing needs at least one.");
  return list;
}
} // namespace Voussoir
