// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/parameters/decimal_comma.h>
#include <voussoir/base/text.h>
#include <voussoir/base/text_file.h>
#include <voussoir/packing/points_file.h>

#include <boost/algorithm/string.hpp>
#include <boost/lexical_cast.hpp>

#include <cmath>
#include <optional>
#include <sstream>

namespace Voussoir
{
template <int dim>
std::string PointList<dim>::describe(const unsigned int i) const
{
  std::string description = text("point ", i, " at ", text_of_point(points[i]));
  if (!lines.empty())
    description += text(" (line ", lines[i], " of '", file.string(), "')");
  return description;
}

namespace
{
/** What a line of a file of points is expected to be. */
template <int dim>
constexpr const char *expected_on_line =
    dim == 2 ? "two finite numbers \"x y\"" : "three finite numbers \"x y z\"";

template <int dim>
std::optional<dealii::Point<dim>> point_of(const std::string &content)
{
  std::vector<std::string> words;
  boost::split(words, content, boost::is_any_of(" \t,;"),
               boost::token_compress_on);
  if (words.size() != dim)
    return {};
  dealii::Point<dim> point;
  for (unsigned int d = 0; d < dim; ++d)
    if (!boost::conversion::try_lexical_convert(words[d], point[d]) ||
        !std::isfinite(point[d]))
      return {};
  return point;
}
} // namespace

template <int dim>
PointList<dim> read_points_file(const std::filesystem::path &file)
{
  const std::optional<std::string> all = read_text_file(file);
  if (!all)
    throw InputError("The points file '" + file.string() +
                     "' cannot be read. Paths in a .prm file start at the "
                     "directory of that file.");

  PointList<dim> list;
  list.file = file;
  std::istringstream in(*all);
  std::string line;
  for (unsigned int number = 1; std::getline(in, line); ++number)
  {
    const std::string content = boost::trim_copy_if(
        line.substr(0, line.find('#')), boost::is_any_of(" \t\r"));
    if (content.empty())
      continue;
    const std::optional<dealii::Point<dim>> point = point_of<dim>(content);
    if (!point)
      throw InputError(text("Line ", number, " of the points file '",
                            file.string(), "' is '", content, "'; ",
                            expected_on_line<dim>, " are expected",
                            point_of<dim>(with_decimal_points(content))
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

template struct PointList<2>;
template struct PointList<3>;
template PointList<2> read_points_file<2>(const std::filesystem::path &);
template PointList<3> read_points_file<3>(const std::filesystem::path &);
} // namespace Voussoir
