// SPDX-License-Identifier: LGPL-2.1-or-later

// Drawings as text, in DXF and as a table of curves: stones with arcs in every
// entity that draws them, and lines that bound stones together.

#include <voussoir/base/text_file.h>
#include <voussoir/run/command_line/command_line.h>

#include <nlohmann/json.hpp>

#include "dxf.h"
#include "tests.h"

namespace test_drawn_files
{
using namespace Voussoir;
using namespace drawn;

constexpr double pi = dealii::numbers::PI;

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

void run()
{
  half_disc();
  rings();
  arch();
  walls();
}

const RoomTest test("drawn_files", run);
} // namespace test_drawn_files
