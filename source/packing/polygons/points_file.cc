// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/points_file.h>

#include <boost/algorithm/string.hpp>
#include <boost/lexical_cast.hpp>

#include <cmath>
#include <fstream>

namespace Voussoir
{
std::string PointList::describe(const unsigned int i) const
{
  std::string description = text("point ", i, " at ", text_of_point(points[i]));
  if (!lines.empty())
    description += text(" (line ", lines[i], " of '", file.string(), "')");
  return description;
}

PointList read_points_file(const std::filesystem::path &file)
{
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file))
    throw InputError("The points file '" + file.string() +
                     "' cannot be read. Paths in a .prm file start at the "
                     "directory of that file.");

  PointList list;
  list.file = file;
  std::string line;
  for (unsigned int number = 1; std::getline(in, line); ++number)
  {
    const std::string content = boost::trim_copy_if(
        line.substr(0, line.find('#')), boost::is_any_of(" \t\r"));
    if (content.empty())
      continue;
    std::vector<std::string> words;
    boost::split(words, content, boost::is_any_of(" \t,;"),
                 boost::token_compress_on);
    double x = 0., y = 0.;
    if (words.size() != 2 ||
        !boost::conversion::try_lexical_convert(words[0], x) ||
        !boost::conversion::try_lexical_convert(words[1], y) ||
        !std::isfinite(x) || !std::isfinite(y))
      throw InputError(text("Line ", number, " of the points file '",
                            file.string(), "' is '", content,
                            "'; two finite numbers \"x y\" are expected."));
    list.points.emplace_back(x, y);
    list.lines.push_back(number);
  }
  if (list.points.empty())
    throw InputError("The points file '" + file.string() +
                     "' has no points; a packing needs at least one.");
  return list;
}
} // namespace Voussoir
