// SPDX-License-Identifier: LGPL-2.1-or-later

// Arcs of drawings: their bulges, the chords that take their place,
// and that blocks along an arc have the same vertices on it and are neighbours,
// whichever way each was drawn.

#include <voussoir/packing/polygons/arc.h>
#include <voussoir/packing/polygons/arc_chords.h>
#include <voussoir/packing/polygons/drawn_arcs.h>
#include <voussoir/packing/polygons/polygon_checks.h>

#include "polygons.h"
#include "tests.h"
#include <set>

namespace test_drawn_arcs
{
using namespace Voussoir;
using dealii::Point;
using Points = std::vector<Point<2>>;
using Polygon = PolygonList::Polygon;

constexpr double pi = dealii::numbers::PI;

Point<2> on_circle(const double radius, const double angle)
{
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

PolygonList list_with(
    const std::vector<std::pair<Points, std::vector<double>>> &rings_and_bulges)
{
  PolygonList polygons;
  polygons.file = "drawing.dxf";
  for (const auto &[ring, bulges] : rings_and_bulges)
  {
    Polygon polygon;
    polygon.ring = ring;
    polygon.bulges = bulges;
    polygon.record = polygons.polygons.size() + 1;
    polygons.polygons.push_back(polygon);
  }
  return polygons;
}

/** The ring run the other way, from the same vertex. */
void turn_round(Polygon &polygon)
{
  std::reverse(polygon.ring.begin() + 1, polygon.ring.end());
  std::reverse(polygon.bulges.begin(), polygon.bulges.end());
  for (double &bulge : polygon.bulges)
    bulge = -bulge;
}

void bulges()
{
  double error = 0.;
  for (const double angle : {-6., -3., -1e-3, 1e-3, 1., 3., 6.})
    for (const double part : {0.1, 0.5, 0.8})
    {
      const Point<2> start = on_circle(2., 0.3),
                     middle = on_circle(2., 0.3 + part * angle),
                     end = on_circle(2., 0.3 + angle);
      // Flat arcs are known from their rise, of which rounding is a part.
      const double flat = std::min(1., angle * angle);
      error =
          std::max(error, flat * std::abs(bulge_through(start, middle, end) /
                                              std::tan(0.25 * angle) -
                                          1.));
    }
  check_error("bulges through three points", error, 1e-14);
}

/** The chains that GDAL would make of arcs, and of straight sides around. */
void chains()
{
  const auto arc_of = [](const double from, const double to, const unsigned n) {
    Points points;
    for (unsigned int k = 0; k <= n; ++k)
      points.push_back(on_circle(1., from + (to - from) * k / n));
    return points;
  };
  const auto with_ends = [](Points points) {
    points.insert(points.begin(), {3, 0});
    points.emplace_back(-2, 3);
    return points;
  };
  const Points fine = with_ends(arc_of(0., 2., 1000)),
               usual = with_ends(arc_of(0., 2., 29)),
               coarse = with_ends(arc_of(0., 2., 1));
  const auto off = [](const DrawnChain &chain) {
    return std::abs(chain.bulges[0]) +
           std::abs(chain.bulges[1] - std::tan(0.5)) +
           std::abs(chain.bulges[2]);
  };
  const DrawnChain chain = chain_between(coarse, fine, usual);
  check("vertices of a chain", chain.points == coarse);
  check_error("its bulges", off(chain), 1e-13);
  check("it has no other curves", !chain.has_other_curves);

  // The ends of the arc differ by rounding, and are beside drawn vertices.
  Points rounded = fine, beside = coarse, of_both = usual;
  rounded[1] += Point<2>(1e-13, 2e-13);
  rounded[1001] -= Point<2>(2e-13, 1e-13);
  for (Points *points : {&rounded, &beside, &of_both})
  {
    const Point<2> first = (*points)[1], last = points->end()[-2];
    points->insert(points->begin() + 1, first + Point<2>(0, 3e-13));
    points->insert(points->end() - 1, last + Point<2>(-3e-13, 0));
  }
  const DrawnChain joined = chain_between(beside, rounded, of_both);
  check_error("an arc between vertices that rounding sets beside its ends",
              joined.points.size() == 4 ? off(joined) : 1., 1e-11);

  const DrawnChain straight = chain_between(coarse, coarse, coarse);
  check("a chain without arcs",
        straight.points == coarse &&
            straight.bulges == std::vector<double>(3, 0.));
  const Points repeated = {{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 0}};
  check("a vertex that is drawn twice stays twice",
        chain_between(repeated, repeated, repeated).points == repeated);

  Points circle = arc_of(0., -2. * pi, 3600);
  circle.back() = circle.front();
  const DrawnChain whole =
      chain_between({circle[0], circle[0]}, circle, circle);
  check_error("a circle is two halves",
              whole.points.size() == 3 && whole.points[0] == whole.points[2]
                  ? whole.points[1].distance(-1. * whole.points[0]) +
                        std::abs(whole.bulges[0] + 1.) +
                        std::abs(whole.bulges[1] + 1.)
                  : 1.,
              1e-11);

  const auto flat = [&](const unsigned int n) {
    Points ellipse = arc_of(0., 2., n);
    for (Point<2> &p : ellipse)
      p[1] *= 0.5;
    return ellipse;
  };
  const DrawnChain other = chain_between(flat(1), flat(1000), flat(29));
  check("an ellipse is a chain of straight sides, as usual",
        other.has_other_curves && other.points == flat(29) &&
            !other.has_arcs());
  const DrawnChain lost = chain_between({{0, 0}, {5, 5}}, fine, usual);
  check("chains that do not fit are as usual",
        lost.has_other_curves && lost.points == usual && !lost.has_arcs());
}

/** Half a disc of radius r on a square of 2r, with a given deviation. */
void half_disc()
{
  for (const double r : {1., 250.})
    for (const double deviation : {0.5, 0.1, 1e-2, 1e-3, 1e-4})
    {
      PolygonList polygons = list_with(
          {{{{0, 0}, {2 * r, 0}, {2 * r, 2 * r}, {0, 2 * r}}, {0, 0, 1, 0}}});
      replace_arcs(polygons, deviation * r, 1e-10 * r);
      const Points &ring = polygons.polygons[0].ring;
      // The fewest chords of no more than a right angle.
      unsigned int n = 2;
      while (1. - std::cos(0.5 * pi / n) > deviation)
        ++n;
      const std::string name =
          text("radius ", r, ", deviation ", deviation, " r: ");
      check(name + counted(n, "chord"), ring.size() == 3 + n);
      check_error(name + "area",
                  std::abs(signed_area(ring) / (r * r) - 4. -
                           0.5 * n * std::sin(pi / n)),
                  1e-13);
      std::cout << "  " << polygons.notices.at(0) << std::endl;
    }
}

/** Flat arcs, whose centre is far away, have vertices on them all the same. */
void flat_arcs()
{
  double error = 0.;
  for (const double rise : {1e-2, 1e-4, 1e-6})
  {
    PolygonList polygons =
        list_with({{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {0, 0, rise, 0}}});
    // A tenth of the angle has nearly a hundredth of the rise.
    replace_arcs(polygons, rise / 99., 1e-12);
    // On the circle through (0, 1), (1, 1 + rise) and (2, 1).
    const double radius = 0.5 * (1. + rise * rise) / rise;
    const Points &ring = polygons.polygons[0].ring;
    for (std::size_t i = 2; i < ring.size(); ++i)
    {
      const double x = ring[i][0] - 1.;
      const double sag = x * x / (radius + std::sqrt(radius * radius - x * x));
      error = std::max(error, std::abs(ring[i][1] - (1. + rise - sag)));
    }
    check(text("rise ", rise, " has ", ring.size() - 3, " chords"),
          ring.size() == 13);
  }
  check_error("vertices of flat arcs", error, 2e-15);
}

/** Two stones on both sides of an arc, in all directions. */
void shared_arc()
{
  const double bulge = std::tan(0.25 * 1.2);
  for (const bool is_first_turned : {false, true})
    for (const bool is_second_turned : {false, true})
    {
      PolygonList polygons =
          list_with({{{{0, 0}, {3, 0}, {3, 1}, {0, 1.1}}, {0, 0, bulge, 0}},
                     {{{0, 1.1}, {3, 1}, {3, 3}, {0, 3}}, {-bulge, 0, 0, 0}}});
      if (is_first_turned)
        turn_round(polygons.polygons[0]);
      if (is_second_turned)
        turn_round(polygons.polygons[1]);
      replace_arcs(polygons, 1e-3, 1e-10);
      std::set<std::pair<double, double>> places;
      for (const Polygon &polygon : polygons.polygons)
        for (const Point<2> &p : polygon.ring)
          places.emplace(p[0], p[1]);
      const std::size_t n = polygons.polygons[0].ring.size() - 3;
      PolygonGenerator generator;
      dealii::ParameterHandler prm;
      generator.add_parameters(prm);
      generator.give(polygons);
      const Packing<2> packing(generator.generate("", Terminal::silent()));
      const double radius = 0.5 * std::hypot(3., 0.1) / std::sin(0.6);
      const unsigned int expected =
          std::ceil(1.2 / (4. * std::asin(std::sqrt(0.5e-3 / radius))));
      check(text("an arc of ", n, " chords, ",
                 is_first_turned ? "turned" : "as it is", " and ",
                 is_second_turned ? "turned" : "as it is"),
            n == expected && polygons.polygons[1].ring.size() == 3 + n &&
                places.size() == 4 + 2 + n - 1 &&
                packing.interfaces().size() == n);
    }
}

/** The arc of one stone below two, and of three along one, at other places. */
void divided_arc()
{
  const auto sector = [](const double r, const double R, const double from,
                         const double to) {
    const double bulge = std::tan(0.25 * (to - from));
    return std::make_pair(Points({on_circle(r, from), on_circle(R, from),
                                  on_circle(R, to), on_circle(r, to)}),
                          std::vector<double>({0, bulge, 0, -bulge}));
  };
  // Two rings of an arch with joints that do not meet.
  PolygonList polygons = list_with(
      {sector(2, 3, 0.2, 1.2), sector(2, 3, 1.2, 2.6), sector(3, 4, 0.2, 0.9),
       sector(3, 4, 0.9, 1.9), sector(3, 4, 1.9, 2.6)});
  turn_round(polygons.polygons[1]);
  turn_round(polygons.polygons[3]);
  PolygonGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Arc tolerance", 1e-3);
  generator.give(polygons);
  const Packing<2> packing(generator.generate("", Terminal::silent()));
  double along = 0., error = 0.;
  unsigned int n_along = 0;
  for (const auto &interface : packing.interfaces())
    if (const double r = interface.midpoint().norm();
        std::abs(r - 3.) < 1e-2 && interface.length < 0.9)
    {
      along += interface.length;
      ++n_along;
      error = std::max(error, 3. - r);
    }
  // Arcs from 0.2 to 0.9, 1.2, 1.9 and 2.6, each in its own chords.
  double expected = 0.;
  unsigned int n_expected = 0;
  for (const double angle : {0.7, 0.3, 0.7, 0.7})
  {
    const unsigned int n =
        std::ceil(angle / (4. * std::asin(std::sqrt(0.5e-3 / 3.))));
    expected += 6. * n * std::sin(0.5 * angle / n);
    n_expected += n;
  }
  check("joints between the rings", n_along == n_expected);
  check_error("their length", std::abs(along / expected - 1.), 1e-13);
  check_error("their distance from the arc", error, 1e-3);
  check("joints in all", packing.interfaces().size() == n_expected + 3);
  check("no gaps", packing.gaps().empty());
}

/** A ring of stones, drawn in turn in both directions. */
void closed_ring()
{
  for (const unsigned int n : {5u, 12u, 33u})
    for (const unsigned int turned : {1u, 2u, 3u})
    {
      std::vector<std::pair<Points, std::vector<double>>> stones;
      for (unsigned int k = 0; k < n; ++k)
      {
        const double from = 2. * pi * k / n, to = 2. * pi * (k + 1) / n;
        const double bulge = std::tan(0.25 * (to - from));
        stones.push_back({{on_circle(1., from), on_circle(1.5, from),
                           on_circle(1.5, to), on_circle(1., to)},
                          {0, bulge, 0, -bulge}});
      }
      PolygonList polygons = list_with(stones);
      for (unsigned int k = 0; k < n; k += turned)
        turn_round(polygons.polygons[k]);
      PolygonGenerator generator;
      dealii::ParameterHandler prm;
      generator.add_parameters(prm);
      generator.give(polygons);
      const Packing<2> packing(generator.generate("", Terminal::silent()));
      double area = 0.;
      for (unsigned int c = 0; c < packing.n_cells(); ++c)
        area += packing.area(c);
      check(text("a ring of ", n, ", each ", turned, ". stone turned"),
            packing.interfaces().size() == n &&
                std::abs(area / (1.25 * pi) - 1.) < 4e-3);
    }
}

void failures()
{
  PolygonList polygons =
      list_with({{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {0, 1, 0, 0}}});
  show_refusal([&] { replace_arcs(polygons, 1e-10, 1e-10); });
}

void run()
{
  bulges();
  chains();
  half_disc();
  flat_arcs();
  shared_arc();
  divided_arc();
  closed_ring();
  failures();
}

const RoomTest test("drawn_arcs", run);
} // namespace test_drawn_arcs
