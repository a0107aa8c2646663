// SPDX-License-Identifier: LGPL-2.1-or-later

// Lines of drawings: rings that rounding left open are closed, and lines that
// meet bound cells together: the walls of the generator, drawn by lines that
// stones share or each have, with lines that run through, stop short and cross.
// What bounds no cell is named with its place.

#include <voussoir/packing/polygons/drawn_lines.h>
#include <voussoir/packing/polygons/line_work.h>

#include "polygons.h"
#include "tests.h"
#include <random>

namespace test_drawn_lines
{
using namespace Voussoir;
using dealii::Point;
using Points = std::vector<Point<2>>;
using Polygon = PolygonList::Polygon;
using Parameters = std::vector<std::pair<std::string, std::string>>;

/** A drawing of lines; its polygons are closed. */
struct LineDrawing
{
  LineDrawing() { list.file = "drawing.dxf"; }

  void add(const Points &points,
           const bool is_open,
           const std::string &layer = "stone")
  {
    Polygon polygon;
    polygon.ring = points;
    polygon.is_line = true;
    polygon.is_open = is_open;
    polygon.group = layer;
    polygon.record = list.polygons.size() + 1;
    polygon.detail = "layer '" + layer + "'";
    list.polygons.push_back(polygon);
  }
  void
  line(const Point<2> &a, const Point<2> &b, const std::string &layer = "stone")
  {
    add({a, b}, true, layer);
  }
  CellLoops cells(Parameters parameters = {{"Lines", "join"}}) const
  {
    PolygonGenerator generator;
    dealii::ParameterHandler prm;
    generator.add_parameters(prm);
    for (const auto &[name, value] : parameters)
      prm.set(name, value);
    PolygonList drawn = list;
    drawn.record_name = "feature";
    generator.give(drawn);
    return generator.generate("", Terminal::silent());
  }

  PolygonList list;
};

/** Areas, and midpoints and lengths of joints, in an order of their own. */
std::vector<std::array<double, 3>> shape_of(const Packing<2> &packing)
{
  std::vector<std::array<double, 3>> shape;
  const auto rounded = [](const double x) { return std::round(1e8 * x) / 1e8; };
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    shape.push_back(
        {{rounded(packing.centre(c)[0]), rounded(packing.centre(c)[1]),
          rounded(packing.area(c))}});
  for (const auto &joint : packing.interfaces())
    shape.push_back({{rounded(joint.midpoint()[0]),
                      rounded(joint.midpoint()[1]), rounded(joint.length)}});
  std::sort(shape.begin(), shape.end());
  return shape;
}

Packing<2> wall_of(const std::string &bond)
{
  WallGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Bond", bond);
  prm.set("Courses", "3");
  prm.set("Bricks per course", "3");
  prm.set("Width", "3");
  prm.set("Height", "1.5");
  return Packing<2>(generator.generate("", Terminal::silent()));
}

void check_wall(const std::string &what,
                const LineDrawing &drawing,
                const Packing<2> &expected,
                const Parameters &parameters = {{"Lines", "join"}})
{
  const Packing<2> packing(drawing.cells(parameters));
  check(what + ": " + counted(packing.n_cells(), "block") + " and " +
            counted(packing.interfaces().size(), "joint"),
        shape_of(packing) == shape_of(expected));
}

/** The sides of all bricks, each drawn by its brick. */
LineDrawing sides_of_bricks(const Packing<2> &wall)
{
  LineDrawing drawing;
  for (unsigned int c = 0; c < wall.n_cells(); ++c)
  {
    // The corners alone, as one draws a brick.
    double left = 1e9, right = -1e9, low = 1e9, high = -1e9;
    for (unsigned int i = 0; i < wall.n_sides(c); ++i)
    {
      left = std::min(left, wall.vertex(c, i)[0]);
      right = std::max(right, wall.vertex(c, i)[0]);
      low = std::min(low, wall.vertex(c, i)[1]);
      high = std::max(high, wall.vertex(c, i)[1]);
    }
    drawing.line({left, low}, {right, low});
    drawing.line({right, high}, {right, low});
    drawing.line({right, high}, {left, high});
    drawing.line({left, low}, {left, high});
  }
  return drawing;
}

void walls()
{
  for (const std::string bond : {"stack", "running"})
  {
    const Packing<2> wall = wall_of(bond);
    LineDrawing drawing = sides_of_bricks(wall);
    check_wall(bond + ", four lines a brick", drawing, wall);

    LineDrawing once;
    for (const auto &joint : wall.interfaces())
      once.line(joint.midpoint() - 0.5 * joint.length * joint.tangent(),
                joint.midpoint() + 0.5 * joint.length * joint.tangent());
    for (const auto &edge : wall.boundary_edges())
      once.line(edge.start, edge.end);
    check_wall(bond + ", shared lines drawn once", once, wall);

    LineDrawing through;
    for (const double y : {0., 0.5, 1., 1.5})
      through.line({0, y}, {3, y});
    for (const auto &joint : wall.interfaces())
      if (std::abs(joint.normal[0]) > 0.5)
        through.line(joint.midpoint() + Point<2>(0, -0.25),
                     joint.midpoint() + Point<2>(0, 0.25));
    through.line({0, 0}, {0, 1.5});
    through.line({3, 1.5}, {3, 0});
    check_wall(bond + ", bed joints that run through", through, wall);

    // Each end is off by a tenth of the tolerance, in some direction.
    std::mt19937 numbers(5);
    std::uniform_real_distribution<double> angles(0., 6.28);
    for (Polygon &line : through.list.polygons)
      for (Point<2> &p : line.ring)
      {
        const double angle = angles(numbers);
        p += 1e-10 * Point<2>(std::cos(angle), std::sin(angle));
      }
    check_wall(bond + ", ends off by a tenth of the tolerance", through, wall,
               {{"Lines", "join"}, {"Matching tolerance", "1e-9"}});

    LineDrawing scaled = drawing;
    for (Polygon &line : scaled.list.polygons)
      for (Point<2> &p : line.ring)
        p *= 1000.;
    check_wall(bond + ", in mm", scaled, wall,
               {{"Lines", "join"}, {"Scale", "0.001"}});
  }

  // All head joints of a stack bond run through, and cross the beds.
  LineDrawing crossing;
  for (const double y : {0., 0.5, 1., 1.5})
    crossing.line({0, y}, {3, y});
  for (const double x : {0., 1., 2., 3.})
    crossing.line({x, 1.5}, {x, 0});
  check_wall("lines that cross", crossing, wall_of("stack"));

  // An outline, divided by lines: the stones belong to its group.
  LineDrawing outline;
  outline.add({{0, 0}, {3, 0}, {3, 1.5}, {0, 1.5}}, false, "wall");
  outline.line({0, 0.5}, {3, 0.5}, "joint");
  outline.line({0, 1}, {3, 1}, "joint");
  outline.line({1, 0}, {1, 1.5}, "joint");
  outline.add({{2, 0}, {2, 0.5}, {2, 1.5}}, true, "joint");
  check_wall("an outline divided by lines", outline, wall_of("stack"));
  check("its stones are of the group of the outline",
        outline.cells().group_names == std::vector<std::string>{"wall"});

  // The stones around are closed, and enclose an opening.
  LineDrawing opening;
  for (const auto &[x, y] : std::vector<std::pair<int, int>>{
           {0, 0}, {1, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {1, 2}})
    opening.add(rectangle(x, y, 1, 1), false);
  opening.line({2, 2}, {3, 2}, "corner");
  opening.line({3, 2}, {3, 3}, "corner");
  opening.line({3, 3}, {2, 3}, "corner");
  const CellLoops around = opening.cells();
  check("an opening that closed lines enclose, and a stone of three lines "
        "beside them",
        has_counts(Packing<2>(around), {8, 8, 16}) &&
            around.group_names ==
                std::vector<std::string>({"stone", "corner"}) &&
            around.records.back() == 8);

  // Without lines that are open nothing changes, to the bit.
  LineDrawing closed;
  closed.add(rectangle(0.1, 0.2, 0.3, 0.7), false);
  closed.add(rectangle(0.4, 0.2, 0.3, 0.7), false);
  check("closed lines are as without joining",
        closed.cells().vertices == closed.cells({}).vertices &&
            closed.cells().loops == closed.cells({}).loops);
}

/** Lines on two layers: a cell is of that with the longest part of it. */
void groups()
{
  LineDrawing drawing;
  drawing.add({{1, 0}, {0, 0}, {0, 1}, {1, 1}}, true, "left");
  drawing.line({1, 0}, {1, 1}, "middle");
  drawing.add({{1, 0}, {2, 0}, {2, 1}, {1, 1}}, true, "right");
  const CellLoops cells = drawing.cells();
  check("groups of cells of lines",
        cells.group_names == std::vector<std::string>({"left", "right"}) &&
            cells.group == std::vector<unsigned int>({0, 1}) &&
            cells.records == std::vector<unsigned int>({1, 3}));
}

/** An arch of two arcs and its joints, half a turn: n blocks. */
void arcs()
{
  LineDrawing drawing;
  const unsigned int n = 7;
  for (const double r : {2., 3.})
  {
    drawing.add({{r, 0}, {-r, 0}}, true);
    drawing.list.polygons.back().bulges = {1., 0.};
  }
  for (unsigned int k = 0; k <= n; ++k)
  {
    const double angle = dealii::numbers::PI * k / n;
    const Point<2> direction(std::cos(angle), std::sin(angle));
    drawing.line(2. * direction, 3. * direction);
  }
  const Packing<2> packing(
      drawing.cells({{"Lines", "join"}, {"Arc tolerance", "1"}}));
  double error = 0.;
  const double sine = std::sin(dealii::numbers::PI / n);
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    error = std::max(error, std::abs(packing.area(c) / (2.5 * sine) - 1.));
  check("an arch of two arcs and joints",
        has_counts(packing, {n, n - 1, 2 * n + 2}));
  check_error("areas of its blocks", error, 1e-13);
}

/** Rings that rounding leaves open, of WKT and of lines. */
void closing()
{
  write_file("open.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 1e-13 0))\n"
                         "POLYGON ((1 0, 2 0, 2 1, 1 1, 1 0))\n");
  check("a ring that rounding leaves open",
        has_counts(Packing<2>(imported_cells("open.wkt")), {2, 1, 6}));
  write_file("open.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 1e-4 0))\n"
                         "POLYGON ((1 0, 2 0, 2 1, 1 1, 1 0))\n");
  show_refusal([] { imported_cells("open.wkt"); });
  show_refusal([] { imported_cells("open.wkt", {{"Scale", "1000"}}); });
  check("within a larger tolerance",
        has_counts(Packing<2>(imported_cells("open.wkt",
                                             {{"Matching tolerance", "2e-4"}})),
                   {2, 1, 6}));

  LineDrawing drawing;
  drawing.add({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2e-11}}, true);
  drawing.add({{1, 0}, {2, 0}, {2, 1}, {1, 1}}, false);
  check("a line that rounding leaves open",
        has_counts(Packing<2>(drawing.cells({})), {2, 1, 6}));
  drawing.line({5, 5}, {7.5, 6}, "dimension");
  drawing.line({7, 5}, {7, 6}, "dimension");
  const CellLoops cells = drawing.cells({{"Lines", "ignore"}});
  check("open lines are left out", cells.n_cells() == 2);
  for (const std::string &notice : cells.notices)
    std::cout << "  " << notice << std::endl;
  show_refusal([&] { drawing.cells({}); });
  show_refusal([&] { drawing.cells({{"Scale", "0.01"}}); });
}

void failures()
{
  const auto square = [] {
    LineDrawing drawing;
    drawing.line({0, 0}, {100, 0});
    drawing.line({100, 0}, {100, 100});
    drawing.line({100, 100}, {0, 100});
    return drawing;
  };
  const Parameters in_mm = {{"Lines", "join"}, {"Scale", "0.01"}};
  std::cout << "A gap" << std::endl;
  LineDrawing drawing = square();
  drawing.line({0, 100}, {0, 2});
  show_refusal([&] { drawing.cells(in_mm); });
  check("is closed by the tolerance",
        has_counts(Packing<2>(drawing.cells({{"Lines", "join"},
                                             {"Scale", "0.01"},
                                             {"Matching tolerance", "0.02"}})),
                   {1, 0, 4}));
  std::cout << "A line that goes on too far" << std::endl;
  drawing = square();
  drawing.line({0, 101}, {0, 0});
  show_refusal([&] { drawing.cells(in_mm); });
  std::cout << "A line between two cells" << std::endl;
  drawing = square();
  drawing.line({0, 100}, {0, 0});
  for (const Polygon &line : square().list.polygons)
    drawing.line(line.ring[0] + Point<2>(200, 0),
                 line.ring[1] + Point<2>(200, 0));
  drawing.line({200, 100}, {200, 0});
  drawing.line({100, 50}, {200, 50});
  show_refusal([&] { drawing.cells(in_mm); });
  std::cout << "A cell in another" << std::endl;
  drawing = square();
  drawing.line({0, 100}, {0, 0});
  drawing.line({20, 20}, {40, 20});
  drawing.line({40, 20}, {30, 40});
  drawing.line({30, 40}, {20, 20});
  show_refusal([&] { drawing.cells(in_mm); });
  std::cout << "A cell that hangs in the corner of another" << std::endl;
  drawing = square();
  drawing.line({0, 100}, {0, 0});
  drawing.line({0, 0}, {40, 20});
  drawing.line({40, 20}, {20, 40});
  drawing.line({20, 40}, {0, 0});
  show_refusal([&] { drawing.cells(in_mm); });
  std::cout << "A coordinate that is none" << std::endl;
  drawing = square();
  drawing.line({0, 100}, {0, 0});
  const double none = std::numeric_limits<double>::infinity();
  drawing.add({{200, 0}, {none, 0}, {200, 100}}, false);
  show_refusal([&] { drawing.cells(in_mm); });
  std::cout << "One line" << std::endl;
  drawing = {};
  drawing.line({0, 100}, {50, 0});
  show_refusal([&] { drawing.cells(in_mm); });
  std::cout << "None that is closed" << std::endl;
  show_refusal([&] { drawing.cells({{"Lines", "ignore"}}); });
  std::cout << "Layers where there are none" << std::endl;
  show_refusal([&] { drawing.cells({{"Layers", "stone"}}); });
  write_file("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n");
  show_refusal([] {
    imported_cells("square.wkt", {{"Layer groups", "a: b"}});
  });
}

void run()
{
  walls();
  groups();
  arcs();
  closing();
  failures();
}

const RoomTest test("drawn_lines", run);
} // namespace test_drawn_lines
