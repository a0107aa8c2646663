// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polygons/readers.h>

// It converts numbers that no integer holds, and doubles that of edges; what
// comes of them is refused, or not used.
#ifdef __clang__
#pragma clang attribute push(                                                  \
    __attribute__((                                                            \
        no_sanitize("float-cast-overflow", "signed-integer-overflow"))),       \
    apply_to = function)
#endif
#include <CGAL/IO/OFF/File_scanner_OFF.h>
#ifdef __clang__
#pragma clang attribute pop
#endif

#include <algorithm>
#include <sstream>

namespace Voussoir
{
namespace
{
/** Reads one file; one object, used once. */
class OffReader
{
public:
  explicit OffReader(const std::filesystem::path &file)
      : content(read_polygon_text(file)), in(content)
  {
    list.file = file;
  }

  PolygonList read()
  {
    // CGAL reads numbers such as counts as double, and converts what no integer
    // holds; and a vertex may be 0/0. Both are refused by what is read.
    const InvalidOperationsAllowed allowed;
    CGAL::File_scanner_OFF scanner(in);
    check_header(scanner);
    read_vertices(scanner);
    for (unsigned int cell = 0; cell < scanner.size_of_facets(); ++cell)
      read_face(scanner, cell);
    return std::move(list);
  }

private:
  [[noreturn]] void refuse(const std::string &fault)
  {
    throw InputError("The OFF file '" + list.file.string() + "' " + fault);
  }

  /** The number of the line that was read last. */
  unsigned int count_lines()
  {
    const std::streamoff offset =
        in.rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in);
    const std::size_t last = std::max<std::streamoff>(offset - 1, 0);
    if (last > counted_up_to)
    {
      line += std::count(content.begin() + counted_up_to,
                         content.begin() + last, '\n');
      counted_up_to = last;
    }
    return line;
  }

  void check_header(const CGAL::File_scanner_OFF &scanner)
  {
    if (!in || scanner.binary())
      refuse(
          "does not begin as a text file of this format does: 'OFF', and the "
          "numbers of vertices, faces and edges.");
    if (scanner.size_of_facets() == 0)
      refuse("has no faces; a packing needs at least one.");
    // No vertex takes less than "0 0 0" and no face less than "3 0 1 2", so do
    // not make room for more.
    if (scanner.size_of_vertices() + scanner.size_of_facets() >
        content.size() / 6)
      refuse(text("announces ", scanner.size_of_vertices(), " vertices and ",
                  scanner.size_of_facets(),
                  " faces, but is too short to hold them."));
  }

  void read_vertices(CGAL::File_scanner_OFF &scanner)
  {
    bool flat = true;
    for (std::size_t v = 0; v < scanner.size_of_vertices(); ++v)
    {
      double x = 0., y = 0., z = 0., w = 1.;
      scanner.scan_vertex(x, y, z, w);
      if (in.fail() || !std::isfinite(x / w) || !std::isfinite(y / w))
        refuse(text("cannot be read in line ", count_lines(), ": vertex ", v,
                    " of ", scanner.size_of_vertices(),
                    " should be three finite numbers \"x y z\"."));
      flat &= (z == 0.);
      vertices.emplace_back(x / w, y / w);
    }
    if (!flat)
      list.notices.push_back("The z coordinates of '" + list.file.string() +
                             "' are ignored.");
  }

  void read_face(CGAL::File_scanner_OFF &scanner, const unsigned int cell)
  {
    std::size_t n = 0;
    scanner.scan_facet(n, cell);
    bool valid = !in.fail() && n > 0;
    PolygonList::Polygon polygon;
    for (std::size_t i = 0; i < n && valid; ++i)
    {
      std::size_t v = 0;
      scanner.scan_facet_vertex_index(v, i + 1, cell);
      valid = !in.fail() && v < vertices.size();
      if (valid)
        polygon.ring.push_back(vertices[v]);
    }
    polygon.record = count_lines();
    if (!valid)
      refuse(
          text("cannot be read in line ", polygon.record, ": cell ", cell,
               " should be the number of its vertices and then their numbers, "
               "from 0 to ",
               static_cast<long>(vertices.size()) - 1, "."));
    list.polygons.push_back(polygon);
  }

  PolygonList list;
  std::string content;
  std::istringstream in;
  std::vector<dealii::Point<2>> vertices;
  std::size_t counted_up_to = 0;
  unsigned int line = 1;
};
} // namespace

PolygonList read_off_file(const std::filesystem::path &file)
{
  return OffReader(file).read();
}
} // namespace Voussoir
