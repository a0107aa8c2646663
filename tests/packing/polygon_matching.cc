// SPDX-License-Identifier: LGPL-2.1-or-later

// Polygons become neighbours where they touch within the tolerance, whatever
// their orientation and first vertex; a packing that is written and read again
// is the same packing.

#include <voussoir/output/vtu/packing_files.h>
#include <voussoir/packing/polygons/polygon_checks.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "polygons.h"
#include "tests.h"
#include <iomanip>
#include <map>

namespace test_polygon_matching
{
using namespace Voussoir;

using Ring = std::vector<dealii::Point<2>>;

Ring rectangle(const double x0,
               const double y0,
               const double x1,
               const double y1)
{
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

CellLoops matched(const std::vector<Ring> &rings, const double tolerance)
{
  std::ofstream out("rings.wkt");
  out << std::setprecision(17);
  for (const Ring &ring : rings)
  {
    out << "POLYGON((";
    for (const auto &p : ring)
      out << p[0] << ' ' << p[1] << ", ";
    out << ring[0][0] << ' ' << ring[0][1] << "))\n";
  }
  out.close();
  return imported_cells("rings.wkt",
                        {{"Matching tolerance", std::to_string(tolerance)}});
}

/** The lengths of the interfaces between each two cells that have any. */
using Contacts =
    std::map<std::pair<unsigned int, unsigned int>, std::vector<double>>;

/** As Packing finds them, but whatever the shape of the cells. */
Contacts contacts(const CellLoops &cells)
{
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> cell_of;
  const auto visit_sides = [&](const auto &visit) {
    for (unsigned int c = 0; c + 1 < cells.first.size(); ++c)
      for (unsigned int i = cells.first[c]; i < cells.first[c + 1]; ++i)
        visit(c, cells.loops[i],
              cells.loops[i + 1 < cells.first[c + 1] ? i + 1 : cells.first[c]]);
  };
  visit_sides([&](unsigned int c, unsigned int a, unsigned int b) {
    cell_of[{a, b}] = c;
  });
  Contacts found;
  visit_sides([&](unsigned int c, unsigned int a, unsigned int b) {
    const auto other = cell_of.find({b, a});
    if (other != cell_of.end() && c < other->second)
      found[{c, other->second}].push_back(
          cells.vertices[a].distance(cells.vertices[b]));
  });
  for (auto &[pair, lengths] : found)
    std::sort(lengths.begin(), lengths.end());
  return found;
}

Contacts contacts(const Packing<2> &packing)
{
  Contacts found;
  for (const auto &i : packing.interfaces())
    found[{i.cell_minus, i.cell_plus}].push_back(i.length);
  for (auto &[pair, lengths] : found)
    std::sort(lengths.begin(), lengths.end());
  return found;
}

/** True for equal contacts, with lengths that differ by no more than this. */
bool agree(const Contacts &a, const Contacts &b, const double difference)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const auto &x, const auto &y) {
                      return x.first == y.first &&
                             std::equal(x.second.begin(), x.second.end(),
                                        y.second.begin(), y.second.end(),
                                        [&](double s, double t) {
                                          return std::abs(s - t) <= difference;
                                        });
                    });
}

void test_contacts()
{
  const double t = 0.001;
  const Ring below = rectangle(0, 0, 2, 1);

  CellLoops cells =
      matched({below, rectangle(0, 1, 1, 2), rectangle(1, 1, 2, 2)}, t);
  check("T-junction: three interfaces of length 1",
        has_counts(Packing<2>(cells), {3, 3, 7}) &&
            agree(contacts(cells),
                  {{{0, 1}, {1}}, {{0, 2}, {1}}, {{1, 2}, {1}}}, 1e-15));

  cells = matched({below, rectangle(1, 1, 3, 2)}, t);
  check("partial contact: one interface of length 1",
        has_counts(Packing<2>(cells), {2, 1, 8}) &&
            agree(contacts(cells), {{{0, 1}, {1}}}, 1e-15));

  cells = matched({below, rectangle(0.5, 1, 1.25, 2)}, t);
  check("contact in the middle of a side",
        has_counts(Packing<2>(cells), {2, 1, 8}) &&
            agree(contacts(cells), {{{0, 1}, {0.75}}}, 1e-15));

  cells = matched({below, rectangle(2, 1, 3, 2)}, t);
  check("cells that meet in a corner are no neighbours",
        has_counts(Packing<2>(cells), {2, 0, 8}));

  check("a gap of half the tolerance is closed",
        agree(contacts(matched({below, rectangle(1, 1.0005, 3, 2)}, t)),
              {{{0, 1}, {1}}}, 2e-6));
  check("a gap of twice the tolerance stays open",
        contacts(matched({below, rectangle(1, 1.002, 3, 2)}, t)).empty());
  check("an overlap of half the tolerance is a contact",
        agree(contacts(matched({below, rectangle(1, 0.9995, 3, 2)}, t)),
              {{{0, 1}, {1}}}, 2e-6));
}

void test_notice_of_gaps()
{
  const Ring below = rectangle(0, 0, 2, 1);
  const Ring left = rectangle(0, 1.0005, 1, 2), right = rectangle(1, 1, 2, 2);
  for (const double tolerance : {0.0001, 0.001})
  {
    const CellLoops cells = matched({below, left, right}, tolerance);
    std::cout << "at " << tolerance << ": " << contacts(cells).size()
              << " pairs in contact" << std::endl;
    for (const std::string &notice : cells.notices)
      std::cout << "  " << notice << std::endl;
  }
  check("no notice of a gap that was meant",
        matched({below, rectangle(0, 1.1, 2, 2)}, 0.0001).notices.empty());
}

void test_small_sides()
{
  const double t = 0.001;
  CellLoops cells = matched({{{0, 0}, {1, 0}, {1, 1}, {0.9995, 1.0005}, {0, 1}},
                             rectangle(1, 0, 2, 1)},
                            t);
  check("a side shorter than the tolerance vanishes",
        cells.vertices.size() == 6 &&
            agree(contacts(cells), {{{0, 1}, {1}}}, 1e-15));

  // The corner of the square is within the tolerance of two sides of the
  // triangle, of which it must split only the one that it lies on.
  cells = matched({{{0, 0}, {1, 0}, {1, 0.8}},
                   {{0.0012, -1}, {1, -1}, {1, 0}, {0.0012, 0}}},
                  t);
  check("a vertex near a sharp corner splits one side",
        has_counts(Packing<2>(cells), {2, 1, 6}) &&
            agree(contacts(cells), {{{0, 1}, {0.9988}}}, 1e-15));

  // An L with a square in its notch: of the notch only the L is not convex.
  cells = matched(
      {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, rectangle(1, 1, 2, 2)},
      t);
  check("a cell in the notch of another",
        agree(contacts(cells), {{{0, 1}, {1, 1}}}, 1e-15));
}

void test_tolerance_handed_on()
{
  const CellLoops cells = matched({rectangle(0, 0, 2, 1)}, 0.01);
  check("the packing is told the tolerance",
        cells.tolerance >= 0.01 && cells.tolerance <= 0.1);
}

/** What moves blocks visibly is refused; what moves them at all is told. */
void test_moves()
{
  const auto with_gap = [](const double gap) {
    return matched({rectangle(0, 0, 1, 1), rectangle(0, 1 + gap, 1, 2 + gap)},
                   0.002);
  };
  for (const std::string &notice : with_gap(0.0009).notices)
    std::cout << notice << std::endl;
  show_refusal([&] { with_gap(0.0011); });
}

/** The rings of a packing without the vertices within a straight side. */
std::vector<Ring> drawn(const Packing<2> &packing)
{
  std::vector<Ring> rings(packing.n_cells());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    const unsigned int n = packing.n_sides(c);
    for (unsigned int i = 0; i < n; ++i)
    {
      const auto a = packing.vertex(c, i) - packing.vertex(c, i + n - 1);
      const auto b = packing.vertex(c, i + 1) - packing.vertex(c, i);
      if (a[0] * b[1] - a[1] * b[0] > 1e-9 * a.norm() * b.norm())
        rings[c].push_back(packing.vertex(c, i));
    }
  }
  return rings;
}

/** Turn, start elsewhere, and move each vertex by up to a third of t. */
std::vector<Ring> disturbed(std::vector<Ring> rings,
                            const double t,
                            boost::random::mt19937 &engine)
{
  boost::random::uniform_real_distribution<double> noise(-t / 5., t / 5.);
  for (Ring &ring : rings)
  {
    if (engine() % 2 == 0)
      std::reverse(ring.begin(), ring.end());
    std::rotate(ring.begin(), ring.begin() + engine() % ring.size(),
                ring.end());
    for (auto &p : ring)
      p += dealii::Tensor<1, 2>({noise(engine), noise(engine)});
  }
  return rings;
}

void test_noise()
{
  const double t = 1e-5;
  unsigned int n_same = 0;
  boost::random::mt19937 engine(1);
  for (unsigned int trial = 0; trial < 20; ++trial)
  {
    const Packing<2> voronoi = random_packing(50, trial);
    const Packing<2> bond = wall(4, 3);
    for (const Packing<2> *packing : {&voronoi, &bond})
      n_same += agree(
          contacts(*packing),
          contacts(matched(disturbed(drawn(*packing), t, engine), t)), 10 * t);
  }
  check("orientation, first vertex and noise change no contact", n_same == 40);
}

/** Equal to the last bit. */
bool same(const Packing<2> &a, const Packing<2> &b)
{
  const auto same_edge = [](const auto &i, const auto &j) {
    return i.start == j.start && i.end == j.end && i.length == j.length &&
           i.normal == j.normal;
  };
  bool equal = a.n_cells() == b.n_cells();
  for (unsigned int c = 0; equal && c < a.n_cells(); ++c)
    equal = a.centre(c) == b.centre(c) && a.area(c) == b.area(c);
  return equal &&
         std::equal(a.interfaces().begin(), a.interfaces().end(),
                    b.interfaces().begin(), b.interfaces().end(),
                    [&](const auto &i, const auto &j) {
                      return i.cell_minus == j.cell_minus &&
                             i.cell_plus == j.cell_plus && same_edge(i, j);
                    }) &&
         std::equal(a.boundary_edges().begin(), a.boundary_edges().end(),
                    b.boundary_edges().begin(), b.boundary_edges().end(),
                    [&](const auto &i, const auto &j) {
                      return i.cell == j.cell && same_edge(i, j);
                    });
}

void test_round_trip(const std::string &what,
                     const Packing<2> &packing,
                     const std::vector<std::string> &files = {"trip.wkt",
                                                              "trip.off"})
{
  std::ofstream wkt("trip.wkt"), off("trip.off"), centres("trip.txt");
  write_packing_wkt(wkt, packing);
  write_packing_off(off, packing);
  write_centres(centres, packing);
  wkt.close(), off.close(), centres.close();
  for (const std::string &file : files)
  {
    const CellLoops cells =
        imported_cells(file, {{"Centres file", "trip.txt"}});
    const Packing<2> again(cells);
    check(what + " through " + file,
          cells.notices.empty() && same(packing, again));
    if (packing.n_cells() > 1000)
      continue;
    const auto S = tensor(-1.3, 0.1, 0.1, -0.7);
    Solver solver(least_energy);
    check_error(what + " through " + file + ": change of the forces",
                distance(solver.forces(scene_under_stress(packing, 0.3, S)),
                         solver.forces(scene_under_stress(again, 0.3, S))),
                0.);
  }

  const PolygonList polygons = read_polygons("trip.wkt");
  double shortest = 1.;
  for (const auto &i : packing.interfaces())
    shortest = std::min(shortest, i.length);
  check(what + ": the automatic tolerance is far below the shortest edge",
        100. * automatic_tolerance(polygons) < shortest);
}

void test_groups()
{
  Packing<2> packing = wall(2, 2);
  packing.set_group(0, "base");
  for (const unsigned int c : {2, 3, 4})
    packing.set_group(c, "top stone");
  std::ofstream out("trip.wkt");
  write_packing_wkt(out, packing);
  out.close();
  const CellLoops cells = imported_cells("trip.wkt");
  check("the names of groups through WKT",
        cells.group_names ==
                std::vector<std::string>({"base", "brick", "top stone"}) &&
            cells.group == std::vector<unsigned int>({0, 1, 2, 2, 2}));
}

/** A cell that is not convex is taken, and known for what its centre sees. */
void test_star_shapes()
{
  write_file("star.wkt", "POLYGON((0 0,4 0,4 2,2 1.5,0 2,0 0))\n"
                         "POLYGON((0 2,2 1.5,4 2,4 4,0 4,0 2))\n");
  const Packing<2> packing(imported_cells("star.wkt"));
  check("a dented cell that its centre sees whole",
        packing.not_convex() == std::vector<unsigned int>({0}) &&
            packing.interfaces().size() == 2);
  write_file("hook.wkt", "POLYGON((0 0,4 0,4 4,3 4,3 1,0 1,0 0))\n");
  const Packing<2> hook(imported_cells("hook.wkt"));
  check("and one that it does not",
        hook.not_seen_whole() == std::vector<unsigned int>({0}) &&
            packing.not_seen_whole().empty() && !hook.is_seen_whole(0));
}

void run()
{
  test_star_shapes();
  test_contacts();
  test_notice_of_gaps();
  test_small_sides();
  test_tolerance_handed_on();
  test_moves();
  test_noise();
  test_round_trip("wall", wall(12, 6));
  test_round_trip("100 Voronoi cells far from the origin",
                  random_packing(100, 3, {{1e6, 1e6}, {1e6 + 1, 1e6 + 1}}));
  test_round_trip("1,000 Voronoi cells", random_packing(1000, 1));
  test_round_trip("100,000 Voronoi cells", random_packing(100000, 1),
                  {"trip.wkt"});
  test_groups();
}

const RoomTest test("polygon_matching", run);
} // namespace test_polygon_matching
