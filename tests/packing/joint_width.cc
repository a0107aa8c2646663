// SPDX-License-Identifier: LGPL-2.1-or-later

// Whatever the joint width, blocks are joined to their true neighbours or the
// width is refused: nothing is joined through a block, a joint or an opening;
// slates and pinning stones keep their joints. Order, orientation and rotation
// change no joint, and strips of joints cross neither blocks nor each other.

#include <voussoir/base/exceptions.h>
#include <voussoir/packing/polygons/joint_checks.h>

#include <deal.II/boost_adaptors/point.h>

#include <boost/geometry.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "polygons.h"
#include "tests.h"
#include <map>
#include <numeric>
#include <optional>

namespace test_joint_width
{
using namespace Voussoir;
using dealii::Point;

using Ring = std::vector<Point<2>>;
using Engine = boost::random::mt19937;
/** How many joints each two blocks have that have any. */
using Joints = std::map<std::pair<unsigned int, unsigned int>, unsigned int>;

double between(Engine &engine, const double least, const double greatest)
{
  return boost::random::uniform_real_distribution<double>(least,
                                                          greatest)(engine);
}

Ring corners(const double x0, const double y0, const double x1, const double y1)
{
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

CellLoops generated(const std::vector<Ring> &rings,
                    const double width,
                    const double scale = 1.,
                    const double tolerance = 0.)
{
  PolygonGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Joint width", digits(width));
  prm.set("Scale", digits(scale));
  prm.set("Matching tolerance", digits(tolerance));
  generator.give(list_of(rings));
  return generator.generate("", Terminal::silent());
}

/** The joints by the numbers @p order of their blocks. */
Joints joints_of(const CellLoops &cells, const std::vector<unsigned int> &order)
{
  Joints joints;
  const Packing<2> packing(cells);
  for (const auto &i : packing.interfaces())
    ++joints[std::minmax({order[i.cell_minus], order[i.cell_plus]})];
  return joints;
}

Joints joints_of(const CellLoops &cells)
{
  std::vector<unsigned int> order(cells.n_cells());
  std::iota(order.begin(), order.end(), 0);
  return joints_of(cells, order);
}

/** None if the drawing is refused. */
std::optional<Joints> joints_or_none(const std::vector<Ring> &rings,
                                     const double width)
{
  try
  {
    return joints_of(generated(rings, width));
  }
  catch (const InputError &)
  {
    return {};
  }
}

/** The joints of a drawing that is turned, or mirrored, in another order. */
std::optional<Joints> joints_otherwise(const std::vector<Ring> &rings,
                                       const double width,
                                       Engine &engine)
{
  std::vector<unsigned int> order(rings.size());
  std::iota(order.begin(), order.end(), 0);
  for (unsigned int k = order.size(); k > 1; --k)
    std::swap(order[k - 1], order[engine() % k]);
  const double angle = between(engine, 0., 6.),
               mirror = engine() % 2 ? 1. : -1.;
  std::vector<Ring> placed;
  for (const unsigned int k : order)
  {
    Ring ring;
    for (const Point<2> &p : rings[k])
      ring.emplace_back(
          mirror * p[0] * std::cos(angle) - p[1] * std::sin(angle),
          mirror * p[0] * std::sin(angle) + p[1] * std::cos(angle));
    if (engine() % 2 == 0)
      std::reverse(ring.begin(), ring.end());
    std::rotate(ring.begin(), ring.begin() + engine() % ring.size(),
                ring.end());
    placed.push_back(ring);
  }
  try
  {
    return joints_of(generated(placed, width), order);
  }
  catch (const InputError &)
  {
    return {};
  }
}

/** How many of random points in the strips of joints lie in blocks or in other
 * strips, too. */
unsigned int n_crossed(const std::vector<Ring> &rings,
                       const CellLoops &cells,
                       Engine &engine)
{
  namespace bg = boost::geometry;
  using Polygon = bg::model::ring<Point<2>, false, false>;
  std::vector<Polygon> shapes;
  for (const auto &pair : cells.facing)
  {
    shapes.emplace_back();
    for (const unsigned int side : pair)
    {
      const unsigned int c =
          std::upper_bound(cells.first.begin(), cells.first.end(), side) -
          cells.first.begin() - 1;
      for (const unsigned int end : {1, 0})
        shapes.back().push_back(cells.vertex(c, side - cells.first[c] + end));
    }
  }
  const std::size_t n_strips = shapes.size();
  for (const Ring &ring : rings)
    shapes.emplace_back(ring.begin(), ring.end());
  unsigned int n = 0;
  for (std::size_t i = 0; i < n_strips; ++i)
    for (unsigned int k = 0; k < 20; ++k)
    {
      const Polygon &strip = shapes[i];
      const double u = between(engine, 0., 1.), v = between(engine, 0., 1.);
      const Point<2> p = strip[0] + u * (strip[1] - strip[0]),
                     q = strip[3] + u * (strip[2] - strip[3]),
                     x = p + v * (q - p);
      for (std::size_t j = 0; j < shapes.size(); ++j)
        n += i != j && bg::within(x, shapes[j]);
    }
  return n;
}

/** A block of a wall in its course. */
struct Placed
{
  unsigned int course;
  double x0, y0, x1, y1;
};

/** Courses of random blocks, stones or slates, with random gaps around each. */
std::vector<Placed> random_wall(Engine &engine)
{
  std::vector<Placed> blocks;
  double y = 0.;
  for (unsigned int course = 0; course < 6; ++course)
  {
    const double height = engine() % 3 == 0 ? between(engine, 0.05, 0.1)
                                            : between(engine, 0.3, 1.);
    // Up to a fifth of the thickness on each side.
    const auto inset = [&] { return between(engine, 0.001, 0.2) * height; };
    for (double x = 0.; x < 5.;)
    {
      const double length = x > 3. ? 5. - x : between(engine, 0.5, 1.5);
      blocks.push_back({course, x + inset(), y + inset(), x + length - inset(),
                        y + height - inset()});
      x += length;
    }
    y += height;
  }
  return blocks;
}

/** What the wall was made as, where gaps are no wider than @p width. */
Joints true_joints(const std::vector<Placed> &blocks, const double width)
{
  Joints joints;
  for (unsigned int a = 0; a < blocks.size(); ++a)
    for (unsigned int b = a + 1; b < blocks.size(); ++b)
    {
      const Placed &one = blocks[a], &other = blocks[b];
      const bool is_next = one.course == other.course && b == a + 1 &&
                           other.x0 - one.x1 <= width;
      const bool is_above =
          other.course == one.course + 1 && other.y0 - one.y1 <= width &&
          std::min(one.x1, other.x1) > std::max(one.x0, other.x0);
      if (is_next || is_above)
        joints[{a, b}] = 1;
    }
  return joints;
}

void test_walls()
{
  std::cout << "300 random walls with random joint widths" << std::endl;
  Engine engine(1);
  unsigned int n_joined = 0, n_refused = 0, n_true = 0, n_same = 0;
  unsigned int n_inside = 0;
  for (unsigned int trial = 0; trial < 300; ++trial)
  {
    const std::vector<Placed> blocks = random_wall(engine);
    const double width = 0.01 * std::exp(between(engine, 0., std::log(300.)));
    std::vector<Ring> rings;
    for (const Placed &b : blocks)
      rings.push_back(corners(b.x0, b.y0, b.x1, b.y1));
    const auto joints = joints_or_none(rings, width);
    n_same += joints == joints_otherwise(rings, width, engine);
    n_refused += !joints;
    if (!joints)
      continue;
    ++n_joined;
    n_true += *joints == true_joints(blocks, width);
    if (trial % 5 == 0)
      n_inside += n_crossed(rings, generated(rings, width), engine);
  }
  check("many are joined, many are refused", n_joined > 100 && n_refused > 50);
  check("those that are joined have their true joints", n_true == n_joined);
  check("turned, mirrored and in another order", n_same == 300);
  check("strips cross neither blocks nor each other", n_inside == 0);
}

void test_stones()
{
  std::cout << "200 random drawings of stones apart" << std::endl;
  Engine engine(2);
  unsigned int n_same = 0, n_joined = 0, n_inside = 0;
  for (unsigned int trial = 0; trial < 200; ++trial)
  {
    const Packing<2> packing = random_packing(40, trial + 1);
    std::vector<Ring> rings(packing.n_cells());
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
    {
      const double share = between(engine, 0.5, 1.);
      for (unsigned int i = 0; i < packing.n_sides(c); ++i)
        rings[c].push_back(packing.centre(c) +
                           share * (packing.vertex(c, i) - packing.centre(c)));
    }
    const double width = between(engine, 0.02, 0.09);
    const auto joints = joints_or_none(rings, width);
    n_same += joints == joints_otherwise(rings, width, engine);
    n_joined += joints.has_value();
    if (joints && trial % 5 == 0)
      n_inside += n_crossed(rings, generated(rings, width), engine);
  }
  check("many are joined", n_joined > 100);
  check("turned, mirrored and in another order", n_same == 200);
  check("strips cross neither blocks nor each other", n_inside == 0);
}

/** Bricks of 215 x 65 in running bond, with joints of 10; lengths. */
std::vector<Ring> brickwork(const double unit, const bool has_opening)
{
  std::vector<Ring> rings;
  for (int course = 0; course < 7; ++course)
    for (int k = 0; k < 10; ++k)
    {
      const double x = 225. * k + (course % 2) * 112.5, y = 75. * course;
      if (!(has_opening && course == 3 && k == 5))
        rings.push_back(
            corners(unit * x, unit * y, unit * (x + 215.), unit * (y + 65.)));
    }
  return rings;
}

void test_brickwork()
{
  std::cout << "Brickwork, with and without an opening of one brick"
            << std::endl;
  for (const bool has_opening : {false, true})
  {
    const std::vector<Ring> rings = brickwork(1., has_opening);
    const auto exact = joints_or_none(rings, 10.);
    unsigned int n_others = 0, n_refused = 0;
    for (double width = 10.; width < 1000.; width *= 1.02)
    {
      const auto joints = joints_or_none(rings, width);
      n_refused += !joints;
      n_others += joints && joints != exact;
    }
    // In a course 9 heads each; above each other 19 halves of bricks; and the
    // opening has two heads and four beds less.
    std::cout << "  " << exact->size() << " joints" << std::endl;
    check("  no width makes others", n_others == 0 && n_refused > 0);
  }
  const std::vector<Ring> rings = brickwork(1., false);
  std::cout << "In mm, with a width in m that would do" << std::endl;
  show_refusal([&] { generated(rings, 10., 0.001); });
  std::cout << "In mm, with a width that is large anyhow" << std::endl;
  show_refusal([&] { generated(rings, 1000., 0.5); });
  show_refusal([&] { generated(rings, 80.); });
  show_refusal([&] { generated(rings, std::numeric_limits<double>::max()); });
}

void test_thin_blocks()
{
  std::cout << "Slates of 5 between stones, in joints up to 10" << std::endl;
  // Heads of 3 between the slates, and an end that has none.
  std::vector<Ring> rings = {corners(0, 0, 400, 200),
                             corners(0, 209, 400, 400)};
  for (int k = 0; k < 3; ++k)
    rings.push_back(corners(103 * k, 202, 103 * k + 100, 207));
  const Joints joints = joints_of(generated(rings, 10.));
  check("beds above and below, heads, and where there is none",
        joints == Joints({{{0, 1}, 1},
                          {{0, 2}, 1},
                          {{0, 3}, 1},
                          {{0, 4}, 1},
                          {{1, 2}, 1},
                          {{1, 3}, 1},
                          {{1, 4}, 1},
                          {{2, 3}, 1},
                          {{3, 4}, 1}}));

  std::cout << "Two slates whose ends do not face each other" << std::endl;
  check("nothing is joined between them",
        joints_of(generated({corners(0, 0, 203, 200),
                             corners(0, 209, 203, 400),
                             {{0, 202}, {100, 202}, {95, 207}, {0, 207}},
                             {{103, 202}, {203, 202}, {203, 207}, {108, 207}}},
                            9.)) ==
            Joints({{{0, 2}, 1}, {{0, 3}, 1}, {{1, 2}, 1}, {{1, 3}, 1}}));

  std::cout << "A slate that stands back by less than the joint is wide"
            << std::endl;
  const auto behind = [](const double x) {
    return joints_of(generated({corners(0, 0, 100, 50), corners(x, 52, 100, 57),
                                corners(0, 59, 100, 99)},
                               10.));
  };
  check("no joint in front of it",
        behind(8.) == Joints({{{0, 1}, 1}, {{1, 2}, 1}}));
  check("but a longer one",
        behind(10.) == Joints({{{0, 1}, 1}, {{0, 2}, 1}, {{1, 2}, 1}}));

  std::cout << "A pinning stone in a wide joint" << std::endl;
  check("the joint goes on to both sides of it",
        joints_of(generated({corners(0, 0, 100, 50), corners(0, 60, 100, 90),
                             corners(40, 52, 55, 57)},
                            10.)) ==
            Joints({{{0, 1}, 2}, {{0, 2}, 1}, {{1, 2}, 1}}));

  std::cout << "A part of the block itself is between" << std::endl;
  check("a hook",
        joints_of(generated(
            {{{0, 0}, {6, 0}, {6, 5}, {2, 5}, {2, 4}, {5, 4}, {5, 1}, {0, 1}},
             corners(2, 5.2, 4, 8)},
            2.)) == Joints({{{0, 1}, 1}}));
}

/** Four blocks around a hole of that width and height. */
std::vector<Ring> around_a_hole(const double b, const double h)
{
  return {corners(0, 0, 4, 1), corners(0, 1 + h, 4, 2 + h),
          corners(0, 1, 2 - b / 2, 1 + h), corners(2 + b / 2, 1, 4, 1 + h)};
}

void test_openings()
{
  std::cout << "A hole between four blocks is joined across the shorter way"
            << std::endl;
  check("upright",
        joints_of(generated(around_a_hole(0.5, 0.51), 0.6)).count({2, 3}) == 1);
  check("lying",
        joints_of(generated(around_a_hole(0.51, 0.5), 0.6)).count({0, 1}) == 1);
  show_refusal([] { generated(around_a_hole(0.5, 0.5), 0.6); });
  std::cout << "An opening between small blocks" << std::endl;
  show_refusal([] {
    generated({corners(0, 0, 9, 9), corners(9.1, 0, 10, 0.5),
               corners(11.3, 0, 12, 0.5)},
              2.);
  });

  std::cout << "Joints that were made through a block" << std::endl;
  PolygonList polygons = list_of({corners(0, 0, 2, 1), corners(0, 1.2, 2, 2.2),
                                  corners(0, 1.05, 2, 1.15)});
  CellLoops cells = loops_of(polygons);
  cells.facing = {{{2, 4}}};
  show_refusal([&] {
    check_joints(polygons, cells, 1e-10);
    polygons.refuse_faults();
  });
}

void run()
{
  test_walls();
  test_stones();
  test_brickwork();
  test_thin_blocks();
  test_openings();
}

const RoomTest test("joint_width", run);
} // namespace test_joint_width
