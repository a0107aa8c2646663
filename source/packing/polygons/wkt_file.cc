// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/readers.h>

#include <deal.II/boost_adaptors/point.h>

#include <boost/algorithm/string.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/io/wkt/read.hpp>

#include <sstream>

namespace Voussoir
{
namespace
{
using Polygon = boost::geometry::model::polygon<dealii::Point<2>>;
using MultiPolygon = boost::geometry::model::multi_polygon<Polygon>;

constexpr const char *white_space = " \t\r\v\f";

/**
 * The number of characters of a line that a message quotes; a line may be a
 * whole file.
 */
constexpr std::size_t quotation_length = 40;

/** The beginning of @p words in quotation marks, without control characters. */
std::string quote(const std::string &words)
{
  std::string beginning = words.substr(0, quotation_length);
  for (char &c : beginning)
    if (static_cast<unsigned char>(c) < ' ')
      c = ' ';
  return "'" + beginning + (words.size() > quotation_length ? "...'" : "'");
}

/** A line in its parts: "MULTIPOLYGON", " Z ", "(((...)))", "lintel". */
struct Feature
{
  std::string tag;
  std::string dimensions;
  std::string body;
  std::string group;
};

/** Reads one file; one object, used once. */
class WktReader
{
public:
  explicit WktReader(const std::filesystem::path &file) { list.file = file; }

  PolygonList read()
  {
    std::istringstream in(read_polygon_text(list.file));
    for (std::string content; std::getline(in, content);)
    {
      ++line;
      boost::trim_if(content, boost::is_any_of(white_space));
      if (content.empty() || content[0] == '#')
        continue;
      std::string group;
      MultiPolygon polygons;
      try_to([&] {
        const Feature feature = split(content);
        polygons = parse(feature);
        group = feature.group;
      });
      for (const Polygon &polygon : polygons)
        try_to([&] { add(polygon, group); });
    }
    if (list.polygons.empty())
      throw InputError("The file '" + list.file.string() +
                       "' has no polygons; a packing needs at least one.");
    return std::move(list);
  }

private:
  using Kind = DrawingFault::Kind;

  [[noreturn]] void refuse_line(const std::string &fault,
                                const Kind kind = Kind::no_polygon) const
  {
    throw list.fault(kind, list.polygons.size(), line, fault);
  }

  /** Read some of the line; what has a fault counts as a cell, too. */
  template <typename Read>
  void try_to(const Read &read)
  {
    if (!list.passes(read))
      list.polygons.push_back({{}, "", line, true});
  }

  Feature split(const std::string &content) const
  {
    // Extended WKT puts the number of the reference system first.
    std::size_t begin = 0;
    if (boost::istarts_with(content, "SRID="))
      begin = std::min(content.find(';'), content.size() - 1) + 1;
    const std::size_t open = std::min(content.find('(', begin), content.size());

    const std::string head = content.substr(begin, open - begin);
    std::string tag = boost::to_upper_copy(head);
    tag.erase(
        std::remove_if(tag.begin(), tag.end(), boost::is_any_of(white_space)),
        tag.end());
    Feature feature;
    for (const std::string name : {"POLYGON", "MULTIPOLYGON"})
      for (const std::string dimensions : {"", "Z", "M", "ZM"})
      {
        if (tag == name + dimensions + "EMPTY")
          refuse_line("is empty; delete the line.");
        if (tag == name + dimensions)
          feature = {name, dimensions, "", ""};
      }
    if (feature.tag.empty())
      refuse_line("is " + quote(content) +
                  "; each line must be a POLYGON or MULTIPOLYGON, as in "
                  "POLYGON ((0 0, 1 0, 0 1, 0 0)).");

    std::size_t end = open;
    for (int depth = 0; end < content.size(); ++end)
    {
      depth += (content[end] == '(') - (content[end] == ')');
      if (depth == 0)
        break;
    }
    if (end == content.size())
      refuse_line("does not close its parentheses; a line holds one whole "
                  "POLYGON or MULTIPOLYGON.");
    feature.body = content.substr(open, end + 1 - open);
    feature.group = group_name(content.substr(end + 1));
    return feature;
  }

  std::string group_name(const std::string &tail) const
  {
    const std::string separators = ";,\t";
    const std::string rest =
        boost::trim_left_copy_if(tail, boost::is_any_of(" "));
    if (rest.empty())
      return "";
    const std::string name =
        boost::trim_copy_if(rest.substr(1), boost::is_any_of(white_space));
    if (separators.find(rest[0]) == std::string::npos ||
        name.find_first_of(separators) != std::string::npos)
      refuse_line("is followed by " + quote(rest) +
                  "; only a semicolon, comma or tab and the name of one group "
                  "may follow a polygon.");
    return name;
  }

  std::string plane_body(const Feature &feature)
  {
    const std::string delimiters = "(),";
    const std::string &body = feature.body;
    std::size_t n_ordinates =
        feature.dimensions.empty() ? 0 : 2 + feature.dimensions.size();
    std::string plane;
    plane.reserve(body.size());
    for (std::size_t i = 0; i < body.size();)
    {
      plane += body[i];
      const std::size_t next =
          std::min(body.find_first_of(delimiters, i + 1), body.size());
      const std::string between = boost::trim_copy_if(
          body.substr(i + 1, next - i - 1), boost::is_any_of(white_space));
      const bool vertex_expected = body[i] == ',' && next < body.size() &&
                                   (body[next] == ',' || body[next] == ')');
      if (!between.empty() || vertex_expected)
        plane += plane_vertex(between, n_ordinates);
      i = next;
    }
    if (n_ordinates > 2 && !ordinates_ignored)
      list.notices.push_back(
          "The Z or M coordinates of '" + list.file.string() +
          "' are ignored, first in line " + std::to_string(line) + ".");
    ordinates_ignored |= n_ordinates > 2;
    return plane;
  }

  std::string plane_vertex(const std::string &vertex,
                           std::size_t &n_ordinates) const
  {
    std::vector<std::string> words;
    boost::split(words, vertex, boost::is_any_of(white_space),
                 boost::token_compress_on);
    if (n_ordinates == 0)
      n_ordinates = words.size();
    if (vertex.empty() || words.size() != n_ordinates || n_ordinates < 2 ||
        n_ordinates > 4)
      refuse_line(
          "has the vertex " + quote(vertex) +
          "; every vertex must have two numbers \"x y\", or all of them "
          "a Z or M as well, with commas between the vertices and a decimal "
          "point in numbers.");
    return words[0] + " " + words[1];
  }

  MultiPolygon parse(const Feature &feature)
  {
    MultiPolygon polygons;
    const std::string plane = feature.tag + plane_body(feature);
    try
    {
      if (feature.tag == "POLYGON")
      {
        polygons.resize(1);
        boost::geometry::read_wkt(plane, polygons[0]);
      }
      else
        boost::geometry::read_wkt(plane, polygons);
    }
    catch (const boost::geometry::read_wkt_exception &exception)
    {
      // "<fault> at '<word>' in '<line>'", of which the word is of use.
      const std::string what = exception.what();
      const std::size_t at = what.find(" at '");
      const std::size_t end = what.find("' in '", at);
      refuse_line(
          "is not well-known text" +
          (at < end && end != std::string::npos
               ? "; " + quote(what.substr(at + 5, end - at - 5)) +
                     " is not expected"
               : std::string()) +
          "; the form is POLYGON ((0 0, 1 0, 0 1, 0 0)) or "
          "MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((1 0, 1 1, 0 1, 1 0))).");
    }
    if (polygons.empty())
      refuse_line("is empty; delete the line.");
    return polygons;
  }

  void add(const Polygon &polygon, const std::string &group)
  {
    std::vector<dealii::Point<2>> ring = polygon.outer();
    if (ring.empty())
      refuse_line("has no vertices; delete it.");
    if (!polygon.inners().empty())
      refuse_line(
          "has a hole; a cell is one loop, so cut it into cells without "
          "holes.",
          Kind::hole);
    for (const dealii::Point<2> &p : ring)
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
        refuse_line("has the vertex " + text_of_point(p) +
                        "; coordinates must be finite.",
                    Kind::bad_vertex);
    const bool returns = ring.size() > 1 && ring.front() == ring.back();
    if (returns)
      ring.pop_back();
    list.polygons.push_back({ring, group, line});
    list.polygons.back().is_open = !returns;
  }

  PolygonList list;
  unsigned int line = 0;
  bool ordinates_ignored = false;
};
} // namespace

PolygonList read_wkt_file(const std::filesystem::path &file)
{
  return WktReader(file).read();
}
} // namespace Voussoir
