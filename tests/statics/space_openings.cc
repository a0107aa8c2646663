// SPDX-License-Identifier: LGPL-2.1-or-later

// Whether a motion opens every joint in space, or pressures balance by
// themselves. Each proof is added up again here: the jumps at all vertices, or
// the sums of forces and moments on all blocks. Columns, arches, wedges and
// prisms that are locked, with and without turning; grains in open and closed
// boxes; turned, moved, and in another order.

#include <voussoir/analyses/space/clamping.h>
#include <voussoir/packing/polyhedra/generators/block_builder.h>

#include "space_scenes.h"
#include <limits>

namespace test_space_openings
{
using namespace Voussoir;
using dealii::Point;

constexpr double pi = 3.14159265358979323846;

/** The least opening at a vertex, over the largest displacement. */
double least_opening(const Packing<3> &packing, const SpaceMotion &motion)
{
  double least = std::numeric_limits<double>::infinity(), largest = 0.;
  for (const Vector3 &u : motion.displacement)
    largest = std::max(largest, u.norm());
  const auto moved = [&](const unsigned int c, const Point<3> &x) {
    Vector3 u;
    if (c == packing.ground())
      return u;
    u = motion.displacement[c];
    if (!motion.rotation.empty())
      u += cross_product_3d(motion.rotation[c], x - packing.centre(c));
    return u;
  };
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const auto &i = packing.interfaces()[e];
    for (const Point<3> &x : packing.polygon(e))
      least = std::min(least, (moved(i.cell_plus, x) - moved(i.cell_minus, x)) *
                                  i.normal);
  }
  return least / largest;
}

/** What forces leave on the blocks, over the sum of their sizes; infinite if
 * one of them pulls, or acts along its joint. */
double
imbalance(const Packing<3> &packing, const FaceForces &forces, const bool turns)
{
  std::vector<Vector3> sum(packing.n_cells() + 1), moment(sum);
  double size = 0.;
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
  {
    const auto &i = packing.interfaces()[e];
    for (unsigned int k = forces.first[e]; k < forces.first[e + 1]; ++k)
    {
      const PointForce &of = forces.list[k];
      const double pressure = -of.force * i.normal;
      if (!(pressure >= 0.) ||
          (of.force + pressure * i.normal).norm() > 1e-14 * pressure)
        return std::numeric_limits<double>::infinity();
      size += pressure;
      for (const auto &[c, sign] :
           {std::pair(i.cell_minus, 1.), std::pair(i.cell_plus, -1.)})
      {
        sum[c] += sign * of.force;
        if (c < packing.n_cells())
          moment[c] +=
              sign * cross_product_3d(of.place - packing.centre(c), of.force);
      }
    }
  }
  double left = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    left += sum[c].norm() +
            (turns ? moment[c].norm() / std::cbrt(packing.volume(c)) : 0.);
  return size > 0. ? left / size : std::numeric_limits<double>::infinity();
}

/** "opens", "clamped" or "unknown", with its proof. */
std::string proven(const SpaceCase &of, Clamping *const found = nullptr)
{
  const Clamping clamping = find_clamping(*of.blocks(), Terminal::silent());
  if (found)
    *found = clamping;
  if (clamping.opens() && clamping.is_clamped())
    return "both";
  if (clamping.opens())
    return least_opening(of.packing, clamping.opening) > 0. ? "opens"
                                                            : "wrong motion";
  if (!clamping.is_clamped())
    return "unknown";
  return imbalance(of.packing, clamping.self_stress, of.turns) <= 1e-10
             ? "clamped"
             : "wrong forces";
}

/** Blocks that turn and that do not have the same answer. */
void check_both(const std::string &name,
                const std::string &expected,
                SpaceCase of)
{
  for (const bool turns : {false, true})
  {
    of.turns = turns;
    const std::string answer = proven(of);
    check(name + (turns ? ", turning: " : ": ") + expected, answer == expected);
  }
}

/** Boxes above each other, on z = 0. */
SpaceCase column(const unsigned int n)
{
  CellFaces cells;
  for (unsigned int k = 0; k < n; ++k)
    add_box(cells, {0., 0., 1. * k}, {1., 1., k + 1.});
  return SpaceCase(Packing<3>(cells));
}

/** Wedges of an arch of an angle, between the rays at its ends. */
SpaceCase arch(const unsigned int n, const double embrace)
{
  BlockBuilder builder({"voussoir"});
  for (unsigned int k = 0; k < n; ++k)
  {
    BlockBuilder::Loop loops[2];
    for (unsigned int end : {0u, 1u})
    {
      const double angle = 0.5 * pi + embrace * (0.5 - (k + 1. * end) / n);
      for (const double y : {0., 1.})
        for (const double r : {y == 0. ? 1. : 1.2, y == 0. ? 1.2 : 1.})
          loops[end].emplace_back(r * std::cos(angle), y,
                                  5. + r * std::sin(angle));
    }
    builder.add_frustum(loops[0], loops[1], 0);
  }
  SpaceCase of{Packing<3>(builder.take())};
  const double a = 0.5 * (pi - embrace);
  const Vector3 right = vector(std::sin(a), 0., -std::cos(a)),
                left = vector(-std::sin(a), 0., -std::cos(a));
  of.support([&](const auto &face) {
    const auto is_end = [&](const Vector3 &normal, const double sign) {
      return (face.normal - normal).norm() < 1e-9 &&
             sign * face.centroid[0] > 0.;
    };
    return is_end(right, 1.) || is_end(left, -1.);
  });
  return of;
}

/** A prism over a triangle, wider above by a taper, held at its sides. */
SpaceCase prism(const std::vector<Point<2>> &base, const double taper)
{
  Point<2> middle;
  for (const Point<2> &p : base)
    middle += p / double(base.size());
  BlockBuilder::Loop lower, upper;
  for (const Point<2> &p : base)
  {
    const Point<2> above = middle + (1. + taper) * (p - middle);
    lower.emplace_back(p[0], p[1], 1.);
    upper.emplace_back(above[0], above[1], 2.);
  }
  BlockBuilder builder({"key"});
  builder.add_frustum(lower, upper, 0);
  SpaceCase of{Packing<3>(builder.take())};
  of.support([](const auto &face) { return std::abs(face.normal[2]) < 0.7; });
  return of;
}

/** A block between a wall below z = 5 + a and one above z = 5 + b. */
SpaceCase between_walls(const double a, const double b)
{
  CellFaces cells;
  add_box(cells, {0., 0., 5.}, {1., 1., 7.});
  add_box(cells, {-1., 0., 4.}, {0., 1., 5. + a});
  add_box(cells, {1., 0., 5. + b}, {2., 1., 8.});
  cells.n_fixed = 2;
  SpaceCase of{Packing<3>(cells)};
  of.support([](const auto &) { return false; });
  return of;
}

void single_blocks()
{
  check_both("column", "opens", column(5));
  for (const double degrees : {60., 120., 180.})
    check_both(text("arch of ", degrees), "opens",
               arch(9, degrees / 180. * pi));

  check_both("two walls", "clamped", between_walls(2., 0.));
  check_both("walls that overlap", "clamped", between_walls(1.1, 0.9));
  // Apart in height, they leave the block room to turn.
  SpaceCase apart = between_walls(0.9, 1.1);
  check("walls apart, turning: opens", proven(apart) == "opens");
  apart.turns = false;
  check("walls apart: clamped", proven(apart) == "clamped");

  const std::vector<Point<2>> triangle = {{0., 0.}, {4., 0.}, {0., 3.}};
  for (const double taper : {1e-1, 1e-3, 1e-5, 1e-7})
    check_both(text("key with taper ", taper), "opens", prism(triangle, taper));
  check_both("key that narrows", "opens", prism(triangle, -0.1));
  check_both("key without taper", "clamped", prism(triangle, 0.));
  // Pressures as the sides of the triangle, and nothing else.
  for (const bool turns : {false, true})
  {
    SpaceCase of = prism(triangle, 0.);
    of.turns = turns;
    Clamping found;
    proven(of, &found);
    double error = found.is_clamped() ? 0. : 1.;
    for (unsigned int e = 0; e < 3 && found.is_clamped(); ++e)
    {
      const double area = of.packing.interfaces()[e].area;
      error = std::max(
          error,
          std::abs(found.self_stress.resultant(of.packing, e).force.norm() -
                   area / 5.));
    }
    check_error("  its pressures", error, 1e-12);
  }
  // A loose column beside a clamped block: no motion opens all.
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {1., 1., 1.});
  add_box(cells, {0., 0., 1.}, {1., 1., 2.});
  add_box(cells, {5., 0., 0.}, {6., 1., 1.});
  SpaceCase of{Packing<3>(cells)};
  of.support([](const auto &face) {
    return face.centroid[2] < 1e-9 ||
           (face.centroid[0] > 4. && std::abs(face.normal[0]) > 0.5);
  });
  check_both("column and clamped block", "clamped", of);
  Clamping found;
  proven(of, &found);
  check("  two joints are pressed", found.n_pressed == 2);
}

/** Grains whose sides rest where a predicate says. */
template <typename Predicate>
SpaceCase
grains(const unsigned int n, const unsigned int seed, const Predicate &rests)
{
  SpaceCase of(cells_in_box(n, {1., 1., 1.}, seed));
  of.support(rests);
  return of;
}

void boxes()
{
  for (const unsigned int seed : {1u, 2u})
  {
    check_both("grains on the ground", "opens",
               grains(100, seed,
                      [](const auto &face) { return face.normal[2] < -0.5; }));
    check_both("grains held all around", "clamped",
               grains(100, seed, [](const auto &) { return true; }));
    check_both("grains between two walls", "opens",
               grains(100, seed, [](const auto &face) {
                 return std::abs(face.normal[0]) > 0.5;
               }));
    for (const bool turns : {false, true})
    {
      SpaceCase open = grains(
          100, seed, [](const auto &face) { return face.normal[2] < 0.5; });
      open.turns = turns;
      const std::string answer = proven(open);
      check("grains in an open box: " + answer,
            answer == "opens" || answer == "clamped");
    }
  }
  check_both("grains without supports", "opens",
             grains(100, 3, [](const auto &) { return false; }));
}

/** Blocks that are placed by a rotation and a shift, or in another order. */
struct Placed
{
  CellFaces cells;
  /** What the normals were turned by, and where blocks rest by those before. */
  dealii::Tensor<2, 3> R;
  bool (*rests)(const Vector3 &normal);

  std::string found(const bool turns) const
  {
    SpaceCase of{Packing<3>(cells)};
    of.turns = turns;
    of.support(
        [&](const auto &face) { return rests(transpose(R) * face.normal); });
    Clamping clamping;
    const std::string answer = proven(of, &clamping);
    return clamping.is_clamped() ? text(answer, " by ", clamping.n_pressed)
                                 : answer;
  }
};

Placed turned(Placed blocks, Random &random)
{
  const auto R = random_rotation(random);
  const auto place = [&](const Point<3> &x) {
    return Point<3>(R * (x + vector(100., -50., 20.)));
  };
  blocks.cells = mapped(blocks.cells, place);
  for (Point<3> &centre : blocks.cells.centres)
    centre = place(centre);
  blocks.R = R * blocks.R;
  return blocks;
}

Placed shuffled(Placed blocks, Random &random)
{
  const CellFaces before = blocks.cells;
  const std::vector<unsigned int> order =
      random_order(before.n_cells(), random);
  blocks.cells = renumbered(before, order, random);
  blocks.cells.tolerance = before.tolerance;
  for (unsigned int c = 0; c < before.centres.size(); ++c)
    blocks.cells.centres.push_back(before.centres[order[c]]);
  return blocks;
}

void invariance()
{
  const Box box{{0., 0., 0.}, {1., 1., 1.}};
  CellFaces grains =
      voronoi_cells(random_points(60, 5, box), ConvexPolyhedron(box));
  grains.shared.clear(); // found by their places, in another order too
  CellFaces wall = brick_wall(4, 2, 3);
  const dealii::Tensor<2, 3> as_it_is = dealii::unit_symmetric_tensor<3>();
  std::vector<Placed> all = {
      {grains, as_it_is, [](const Vector3 &n) { return n[2] < 0.5; }},
      {wall, as_it_is, [](const Vector3 &n) { return std::abs(n[0]) > 0.5; }},
      {wall, as_it_is,
       [](const Vector3 &n) { return std::abs(n[0]) > 0.5 || n[2] < -0.5; }}};
  Random random(2);
  for (Placed &blocks : all)
    for (const bool turns : {false, true})
    {
      blocks.cells.tolerance = 1e-9;
      const std::string here = blocks.found(turns);
      check(here + ", as proven",
            here.find("opens") == 0 || here.find("clamped") == 0);
      check("  turned", turned(blocks, random).found(turns) == here);
      check("  in another order",
            shuffled(blocks, random).found(turns) == here);
    }
}

void run()
{
  single_blocks();
  boxes();
  invariance();
}

const RoomTest test("space_openings", run);
} // namespace test_space_openings
