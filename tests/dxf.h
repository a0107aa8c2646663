// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_dxf_h
#define voussoir_tests_dxf_h

#include "polygons.h"
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace drawn
{
using dealii::Point;
using Voussoir::CellLoops;
using Points = std::vector<Point<2>>;
using Parameters = std::vector<std::pair<std::string, std::string>>;

/** A vertex and the bulge of the side behind it. */
struct Vertex
{
  double x, y, bulge = 0.;
};
using Vertices = std::vector<Vertex>;

/** A DXF file of entities with handles from A0 on. */
class Dxf
{
public:
  Dxf() { out << std::setprecision(17) << "0\nSECTION\n2\nENTITIES\n"; }

  void lwpolyline(const std::string &layer,
                  const Vertices &vertices,
                  const bool is_closed = true)
  {
    begin("LWPOLYLINE", layer);
    out << "90\n" << vertices.size() << "\n70\n" << is_closed << '\n';
    for (const Vertex &v : vertices)
      add(v);
  }
  /** The form of AutoCAD's release 12. */
  void polyline(const std::string &layer, const Vertices &vertices)
  {
    begin("POLYLINE", layer);
    out << "66\n1\n70\n1\n";
    for (const Vertex &v : vertices)
    {
      out << "0\nVERTEX\n8\n" << layer << '\n';
      add(v);
    }
    out << "0\nSEQEND\n8\n" << layer << '\n';
  }
  void line(const std::string &layer, const Point<2> &a, const Point<2> &b)
  {
    begin("LINE", layer);
    out << "10\n" << a[0] << "\n20\n" << a[1] << '\n';
    out << "11\n" << b[0] << "\n21\n" << b[1] << '\n';
  }
  /** Counterclockwise from one angle in degrees to another. */
  void arc(const std::string &layer,
           const Point<2> &centre,
           const double radius,
           const double from,
           const double to)
  {
    begin("ARC", layer);
    round(centre, radius);
    out << "50\n" << from << "\n51\n" << to << '\n';
  }
  void
  circle(const std::string &layer, const Point<2> &centre, const double radius)
  {
    begin("CIRCLE", layer);
    round(centre, radius);
  }
  void ellipse(const std::string &layer,
               const Point<2> &centre,
               const double half_length,
               const double ratio)
  {
    begin("ELLIPSE", layer);
    out << "10\n" << centre[0] << "\n20\n" << centre[1] << '\n';
    out << "11\n" << half_length << "\n21\n0\n40\n" << ratio << '\n';
    out << "41\n0\n42\n" << 2. * dealii::numbers::PI << '\n';
  }
  void text_entity(const std::string &layer)
  {
    begin("TEXT", layer);
    out << "10\n0\n20\n0\n40\n1\n1\nwall\n";
  }
  void write(const std::string &file = "drawing.dxf") const
  {
    write_file(file, out.str() + "0\nENDSEC\n0\nEOF\n");
  }

private:
  void begin(const std::string &entity, const std::string &layer)
  {
    out << "0\n" << entity << "\n5\n" << std::hex << std::uppercase << handle++;
    out << std::dec << "\n8\n" << layer << '\n';
  }
  void add(const Vertex &v)
  {
    out << "10\n" << v.x << "\n20\n" << v.y << '\n';
    if (v.bulge != 0.)
      out << "42\n" << v.bulge << '\n';
  }
  void round(const Point<2> &centre, const double radius)
  {
    out << "10\n" << centre[0] << "\n20\n" << centre[1] << '\n';
    out << "40\n" << radius << '\n';
  }

  std::ostringstream out;
  int handle = 0xA0;
};

inline CellLoops cells_of(const Dxf &drawing, const Parameters &parameters = {})
{
  drawing.write();
  return imported_cells("drawing.dxf", parameters);
}
} // namespace drawn

#endif
