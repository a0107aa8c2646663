// SPDX-License-Identifier: LGPL-2.1-or-later

// Drawings as text, in DXF and as a table of curves: stones with arcs in every
// entity that draws them, lines that bound stones together, layers that are
// chosen and grouped, and what messages say of layers and handles.

#include <voussoir/base/text_file.h>
#include <voussoir/run/command_line/command_line.h>

#include <nlohmann/json.hpp>

#include "polygons.h"
#include "tests.h"
#include <iomanip>
#include <regex>

namespace test_drawn_files
{
using namespace Voussoir;
using dealii::Point;
using Points = std::vector<Point<2>>;
using Parameters = std::vector<std::pair<std::string, std::string>>;

constexpr double pi = dealii::numbers::PI;

/** A vertex and the bulge of the side behind it. */
struct Vertex
{
  double x, y, bulge = 0.;
};
using Vertices = std::vector<Vertex>;

/** The same loop from the same vertex, the other way round. */
Vertices turned(const Vertices &loop)
{
  Vertices other;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const std::size_t k = (loop.size() - i) % loop.size();
    other.push_back({loop[k].x, loop[k].y,
                     -loop[(k + loop.size() - 1) % loop.size()].bulge});
  }
  return other;
}

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
    out << "41\n0\n42\n" << 2. * pi << '\n';
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

CellLoops cells_of(const Dxf &drawing, const Parameters &parameters = {})
{
  drawing.write();
  return imported_cells("drawing.dxf", parameters);
}

Packing<2> packing_of(const Dxf &drawing, const Parameters &parameters = {})
{
  return Packing<2>(cells_of(drawing, parameters));
}

/** The fewest chords of an arc that are off by no more than a hundredth. */
unsigned int n_chords(const double radius, const double angle)
{
  unsigned int n = std::ceil(angle / (pi / 2) - 1e-9);
  while (radius * (1. - std::cos(0.5 * angle / n)) > 0.01)
    ++n;
  return n;
}

const Parameters by_hundredths = {{"Arc tolerance", "0.01"}};

void check_areas(const std::string &what,
                 const Packing<2> &packing,
                 const double expected)
{
  double area = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    area += packing.area(c);
  check_error(what, std::abs(area / expected - 1.), 1e-12);
}

/** A square of 2 with half a disc on it, in each entity that draws it. */
void half_disc()
{
  const unsigned int n = n_chords(1., pi);
  const double area = 4. + 0.5 * n * std::sin(pi / n);
  const Vertices stone = {{5, 7}, {7, 7}, {7, 9, 1}, {5, 9}};
  for (const Vertices &vertices : {stone, turned(stone)})
  {
    const std::string way =
        vertices[1].x > 5. ? ", counterclockwise" : ", clockwise";
    Dxf lightweight, old;
    lightweight.lwpolyline("stone", vertices);
    check_areas("half a disc of an LWPOLYLINE" + way,
                packing_of(lightweight, by_hundredths), area);
    old.polyline("stone", vertices);
    check_areas("of a POLYLINE" + way, packing_of(old, by_hundredths), area);
    Dxf in_mm;
    Vertices large = vertices;
    for (Vertex &v : large)
    {
      v.x *= 1e3;
      v.y *= 1e3;
    }
    in_mm.lwpolyline("stone", large);
    check_areas(
        "in mm" + way,
        packing_of(in_mm, {{"Arc tolerance", "0.01"}, {"Scale", "0.001"}}),
        area);
  }
  Dxf apart;
  apart.line("stone", {5, 9}, {5, 7});
  apart.arc("stone", {6, 9}, 1., 0., 180.);
  apart.lwpolyline("stone", {{7, 9}, {7, 7}, {5, 7}}, false);
  check_areas("of two lines and an ARC",
              packing_of(apart, {{"Arc tolerance", "0.01"}, {"Lines", "join"}}),
              area);

  // Less than the disc: an arc of three quarters.
  const unsigned int m = n_chords(1., 1.5 * pi);
  Dxf key;
  key.lwpolyline("key", {{1, 0, std::tan(0.375 * pi)}, {0, -1}, {0, 0}});
  check_areas("three quarters of a disc", packing_of(key, by_hundredths),
              0.5 * m * std::sin(1.5 * pi / m));
  Dxf circle;
  circle.circle("column", {3, 4}, 1.);
  check_areas("a CIRCLE", packing_of(circle, by_hundredths),
              n * std::sin(pi / n));
  Dxf ellipse;
  ellipse.ellipse("column", {3, 4}, 2., 0.5);
  const CellLoops cells = cells_of(ellipse);
  check_areas("an ELLIPSE, by GDAL's chords of four degrees", Packing<2>(cells),
              90. * std::sin(pi / 45.));
  for (const std::string &notice : cells.notices)
    std::cout << "  " << notice << std::endl;

  write_file("stone.csv",
             "WKT,group\n\"CURVEPOLYGON(COMPOUNDCURVE((5 9,5 7,7 7,7 9),"
             "CIRCULARSTRING(7 9,6 10,5 9)))\",a\n");
  check_areas("a CURVEPOLYGON",
              Packing<2>(imported_cells("stone.csv", by_hundredths)), area);
  write_file("stone.csv", "WKT,group\n\"COMPOUNDCURVE((5 9,5 7,7 7,7 9),"
                          "CIRCULARSTRING(7 9,6 10,5 9))\",a\n");
  check_areas("a closed COMPOUNDCURVE",
              Packing<2>(imported_cells("stone.csv", by_hundredths)), area);
}

/** A stone of a ring between two angles. */
Vertices voussoir(const double radius,
                  const double thickness,
                  const double from,
                  const double to)
{
  const auto at = [](const double r, const double angle, const double bulge) {
    return Vertex{r * std::cos(angle), r * std::sin(angle), bulge};
  };
  const double outer = radius + thickness, bulge = std::tan(0.25 * (to - from));
  return {at(radius, from, 0.), at(outer, from, bulge), at(outer, to, 0.),
          at(radius, to, -bulge)};
}

/** Rings of stones: n joints if they close, else n - 1, however drawn. */
void rings()
{
  for (const bool is_whole : {true, false})
    for (const unsigned int n : {5u, 12u})
      for (const unsigned int each : {1u, 2u, 3u})
      {
        Dxf drawing;
        const double angle = is_whole ? 2. * pi : 2.5;
        for (unsigned int k = 0; k < n; ++k)
        {
          const Vertices stone =
              voussoir(1., 0.5, angle * k / n, angle * (k + 1) / n);
          if (k % 2 == 0)
            drawing.lwpolyline("ring", k % each == 0 ? turned(stone) : stone);
          else
            drawing.polyline("ring", k % each == 0 ? turned(stone) : stone);
        }
        const Packing<2> packing = packing_of(drawing, by_hundredths);
        const unsigned int m = n_chords(1.5, angle / n),
                           inner = n_chords(1., angle / n);
        check(text(is_whole ? "a ring" : "an arch", " of ", n, ", each ", each,
                   ". stone turned: ",
                   counted(packing.interfaces().size(), "joint")),
              packing.interfaces().size() == (is_whole ? n : n - 1));
        check_areas("its area", packing,
                    0.5 * n *
                        (2.25 * m * std::sin(angle / n / m) -
                         inner * std::sin(angle / n / inner)));
      }

  // A stone below two along the same arc, which one of them is drawn on.
  Dxf shared;
  shared.lwpolyline("inner", voussoir(1., 1., 0.3, 1.5));
  shared.lwpolyline("outer", turned(voussoir(2., 1., 0.3, 1.)));
  shared.lwpolyline("outer", voussoir(2., 1., 1., 1.5));
  const Packing<2> packing = packing_of(shared, by_hundredths);
  check("an arc with one stone below and two above",
        packing.interfaces().size() ==
                1 + n_chords(2., 0.7) + n_chords(2., 0.5) &&
            packing.gaps().empty());
}

/** The load factor of a scene in scene.prm. */
double factor_of(const std::string &packing)
{
  write_file("scene.prm", "set Output directory = results\n"
                          "set Analysis = load factor\n"
                          "set Rotations = true\n"
                          "subsection Packing\n" +
                              packing +
                              "end\n"
                              "subsection Supports\n"
                              "  set Where = y < 1e-9\n"
                              "end\n"
                              "subsection Loads\n"
                              "  set Body force = 0; -20\n"
                              "end\n"
                              "subsection Live loads\n"
                              "  set Cell forces = at 0.3, 1.05: 0, -1\n"
                              "end\n"
                              "subsection Friction\n"
                              "  set Law = associated Coulomb\n"
                              "  set Coefficient = 0.6\n"
                              "end\n");
  std::ostringstream out, error;
  if (run_command_line({"scene.prm"}, out, error) != 0)
    std::cout << "FAILED: " << error.str() << std::endl;
  const auto summary =
      nlohmann::json::parse(*read_text_file("results/summary.json"));
  return summary["load_factor"]["carried"];
}

/** The arch of the generator, and one drawn with arcs of one chord each. */
void arch()
{
  const unsigned int n = 15;
  Dxf drawing;
  for (unsigned int k = 0; k < n; ++k)
  {
    const Vertices stone = voussoir(0.9, 0.2, pi * k / n, pi * (k + 1) / n);
    drawing.lwpolyline("voussoir", k % 2 == 0 ? turned(stone) : stone);
  }
  drawing.write();
  const double generated =
      factor_of("  set Generator = arch\n"
                "  subsection arch\n    set Mean radius = 1\n"
                "    set Thickness = 0.2\n    set Voussoirs = 15\n  end\n");
  const double drawn = factor_of("  set Generator = polygons\n"
                                 "  subsection polygons\n"
                                 "    set File = drawing.dxf\n"
                                 "    set Arc tolerance = 1\n  end\n");
  check("an arch carries something", generated > 0.1);
  check_error("an arch of arcs and that of the generator",
              std::abs(drawn / generated - 1.), 1e-8);
}

/** Four lines for each of 3 x 3 stones, or lines that they share. */
void walls()
{
  WallGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Bond", "stack");
  prm.set("Courses", "3");
  prm.set("Bricks per course", "3");
  prm.set("Width", "3");
  prm.set("Height", "1.5");
  const Packing<2> wall(generator.generate("", Terminal::silent()));

  Dxf each, shared;
  for (unsigned int c = 0; c < wall.n_cells(); ++c)
    for (unsigned int i = 0; i < 4; ++i)
      each.line("wall", wall.vertex(c, i), wall.vertex(c, (i + 1) % 4));
  for (unsigned int k = 0; k < 4; ++k)
  {
    shared.line("wall", {0., 0.5 * k}, {3., 0.5 * k});
    shared.line("wall", {1. * k, 1.5}, {1. * k, 0.});
  }
  for (const Dxf *drawing : {&each, &shared})
  {
    const Packing<2> drawn = packing_of(*drawing, {{"Lines", "join"}});
    double error = drawn.interfaces().size() == 12 ? 0. : 1.;
    for (const auto &joint : wall.interfaces())
    {
      double nearest = 1.;
      for (const auto &other : drawn.interfaces())
        nearest =
            std::min(nearest, joint.midpoint().distance(other.midpoint()) +
                                  std::abs(joint.length - other.length));
      error = std::max(error, nearest);
    }
    check("a wall of lines has 9 blocks and 12 joints",
          has_counts(drawn, {9, 12, 12}));
    check_error("which are those of the generator", error, 1e-14);
  }
}

/** Stones on three layers, a dimension and a text. */
Dxf three_layers()
{
  Dxf drawing;
  drawing.lwpolyline("pier left", {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  drawing.lwpolyline("pier right", {{2, 0}, {3, 0}, {3, 1}, {2, 1}});
  drawing.lwpolyline("LINTEL", {{0, 1}, {3, 1}, {3, 2}, {0, 2}});
  drawing.line("dimensions", {0, -1}, {3, -1.5});
  drawing.text_entity("dimensions");
  return drawing;
}

void layers()
{
  const Dxf drawing = three_layers();
  const CellLoops stones = cells_of(drawing, {{"Layers", "pier *, LINTEL"}});
  check("chosen layers",
        stones.n_cells() == 3 && stones.notices.empty() &&
            stones.group_names == std::vector<std::string>(
                                      {"pier left", "pier right", "LINTEL"}));
  check("a layer by each wildcard",
        cells_of(drawing, {{"Layers", "pier ?eft, [KL]INTEL"}}).n_cells() == 2);
  const CellLoops grouped =
      cells_of(drawing, {{"Layers", "pier *, LINTEL"},
                         {"Layer groups", "*right: abutment | pier*: pier"}});
  check("groups of layers, the first that fits",
        grouped.group_names ==
            std::vector<std::string>({"pier", "abutment", "LINTEL"}));
  for (const Parameters &parameters : std::vector<Parameters>{
           {{"Layers", "pier *, lintel"}},
           {{"Layers", "dimensions"}, {"Lines", "ignore"}},
           {{"Layers", "pier *,"}},
           {{"Layers", "pier *"}, {"Layer groups", "LINTEL: beam"}},
           {{"Layer groups", "beam"}}})
    show_refusal([&] { cells_of(drawing, parameters); });
  Dxf words;
  words.text_entity("dimensions");
  show_refusal([&] { cells_of(words); });
}

/** Messages have layers, handles or ids, and scaled coordinates. */
void messages()
{
  const Parameters in_mm = {{"Scale", "0.001"}};
  const auto wide = [](const std::string &layer, const double x,
                       const double y) {
    return std::make_pair(
        layer,
        Vertices({{x, y}, {x + 1000, y}, {x + 1000, y + 1000}, {x, y + 1000}}));
  };
  const auto drawn =
      [&](const std::vector<std::pair<std::string, Vertices>> &stones) {
        Dxf drawing;
        for (const auto &[layer, vertices] : stones)
          drawing.lwpolyline(layer, vertices);
        return drawing;
      };
  show_refusal([&] {
    cells_of(drawn({wide("pier", 0, 0), wide("arch", 900, 0)}), in_mm);
  });
  show_refusal([&] {
    cells_of(drawn({{"pier", {{0, 0}, {1000, 1000}, {1000, 0}, {0, 1000}}}}),
             in_mm);
  });
  Dxf open = three_layers();
  show_refusal([&] { cells_of(open, in_mm); });
  write_file("lines.geojson",
             R"({"type": "FeatureCollection", "features": [
      {"type": "Feature", "properties": {}, "geometry": {"type": "LineString",
       "coordinates": [[0, 0], [1000, 0], [1000, 1000], [1, 1]]}}]})");
  show_refusal([&] { imported_cells("lines.geojson", in_mm); });
  const CellLoops cells =
      cells_of(drawn({wide("pier", 0, 0), wide("arch", 1020, 0)}), in_mm);
  std::cout << cells.describe(1) << '\n' << cells.notices.at(0) << std::endl;
  Dxf fine;
  fine.circle("pier", {0, 0}, 1000.);
  show_refusal([&] {
    cells_of(fine, {{"Scale", "0.001"}, {"Arc tolerance", "1e-12"}});
  });
}

/** Open lines are in the pictures of a drawing with several faults. */
void pictures()
{
  Dxf drawing = three_layers();
  drawing.lwpolyline("pier left", {{0, 2}, {1, 2, 0.5}, {1, 3}}, false);
  drawing.write();
  write_file("scene.prm", "set Output directory = faulty\n"
                          "subsection Packing\n"
                          "  set Generator = polygons\n"
                          "  subsection polygons\n"
                          "    set File = drawing.dxf\n"
                          "    set Scale = 0.1\n"
                          "  end\n"
                          "end\n");
  std::ostringstream out, error;
  const int status = run_command_line({"scene.prm", "--quiet"}, out, error);
  std::cout << "status " << status << '\n' << error.str();
  const std::string page = *read_text_file("faulty/drawing_check.html"),
                    grid = *read_text_file("faulty/drawing_check.vtu");
  const std::regex lines("class=\"open\"");
  check("both open lines are on the page",
        std::distance(std::sregex_iterator(page.begin(), page.end(), lines),
                      std::sregex_iterator()) == 2);
  check("and in the grid, with three stones",
        grid.find("NumberOfCells=\"5\"") != std::string::npos);
}

void run()
{
  half_disc();
  rings();
  arch();
  walls();
  layers();
  messages();
  pictures();
}

const RoomTest test("drawn_files", run);
} // namespace test_drawn_files
