// SPDX-License-Identifier: LGPL-2.1-or-later

// Load factors and states in space at extremes: lengths and stresses of 1e-9 to
// 1e9, places 1e6 away, turned, and with blocks and vertices in another order;
// strengths from zero to 1e9 in one packing; slivers; drums of 64 sides; a
// block without joints.

#include <voussoir/packing/polyhedra/generators/column.h>

#include "space_scenes.h"
#include <limits>

namespace test_space_extremes
{
using namespace Voussoir;
using dealii::Point;

/** Where blocks are: what is at x goes to unit (rotation x + shift). */
struct Placement
{
  double unit = 1.;
  dealii::Tensor<2, 3> rotation = dealii::unit_symmetric_tensor<3>();
  Vector3 shift = {};

  Point<3> place(const Point<3> &x) const
  {
    return Point<3>(unit * (rotation * x + shift));
  }
  Point<3> place_before(const Point<3> &y) const
  {
    return Point<3>(transpose(rotation) * (y / unit - shift));
  }
};

/** Blocks on z = 0 with one law, below their weight and a push. */
struct Heap
{
  std::string name;
  CellFaces cells;
  double strength, mu;

  /** The same with stresses in another unit, somewhere else. */
  FactorOf<SpaceScene> factor(const Placement &at, double stress = 1.) const;
};

FactorOf<SpaceScene> Heap::factor(const Placement &at,
                                  const double stress) const
{
  const auto place = [&](const Point<3> &x) { return at.place(x); };
  CellFaces placed = mapped(cells, place);
  for (Point<3> &centre : placed.centres)
    centre = place(centre);
  placed.tolerance *= at.unit;
  SpaceCase of{Packing<3>(placed)};
  of.packing = Packing<3>(placed); // with the foot elsewhere
  const Vector3 up = at.rotation * vector(0., 0., 1.);
  of.support([&](const auto &face) {
    return at.place_before(face.centroid)[2] < 1e-6 && face.normal * up < -0.5;
  });
  of.strength = stress * strength;
  of.mu = mu;
  const double density = stress / at.unit;
  const auto blocks = of.blocks();
  const SpaceScene dead(blocks, body_force(of.packing, -density * up));
  const SpaceScene live(
      blocks,
      body_force(of.packing, density * (at.rotation * vector(1., 0.3, 0.))));
  const auto answer =
      find_load_factor(dead, live, {true, 1e-11}, Terminal::silent());
  return answer.factor ? *answer.factor : FactorOf<SpaceScene>();
}

std::vector<Heap> heaps()
{
  CellFaces wall = brick_wall(3, 1, 4);
  wall.tolerance = 1e-9;
  const CellFaces shell = dome_cells(6, 8, 0.15);
  const Box box{{0., 0., 0.}, {1., 1., 1.}};
  CellFaces grains =
      voronoi_cells(random_points(40, 1, box), ConvexPolyhedron(box));
  // Found by their places, so that they may be put in another order.
  grains.shared.clear();
  grains.tolerance = 1e-9;
  return {{"Wall, Coulomb and cohesion", wall, 0.05, 0.4},
          {"Dome, Coulomb", shell, 0., 0.5},
          {"Grains, Coulomb", grains, 0., 0.8},
          {"Grains, Tresca", grains, 0.5, 0.}};
}

/** The cells from the last to the first, with other numbers of vertices. */
CellFaces reversed(const CellFaces &cells)
{
  std::vector<unsigned int> order;
  for (unsigned int c = cells.n_cells(); c > 0; --c)
    order.push_back(c - 1);
  Random random(1);
  CellFaces others = renumbered(cells, order, random);
  others.tolerance = cells.tolerance;
  for (unsigned int k = 0; k < cells.centres.size(); ++k)
    others.centres.push_back(cells.centres[order[k]]);
  return others;
}

void invariance()
{
  for (const Heap &heap : heaps())
  {
    const FactorOf<SpaceScene> here = heap.factor({});
    std::cout << heap.name << std::endl;
    check("  a factor", here.carried > 0.01 && here.bound < 10.);
    check_error("  width", here.width(), 1e-9);
    const auto compare = [&](const std::string &what,
                             const FactorOf<SpaceScene> &there) {
      check_error("  " + what,
                  std::max(std::abs(there.carried / here.carried - 1.),
                           std::abs(there.bound / here.bound - 1.)),
                  1e-8);
    };
    Placement at;
    for (const double unit : {1e-9, 1e9})
      for (const double stress : {1e-9, 1., 1e9})
      {
        at.unit = unit;
        compare(text("unit of length ", unit, ", of stress ", stress),
                heap.factor(at, stress));
      }
    at = {};
    at.shift = 1e6 * vector(std::sqrt(2.), -std::sqrt(3.), std::sqrt(0.5));
    compare("moved by 1e6", heap.factor(at));
    at = {};
    Random random(3);
    at.rotation = random_rotation(random);
    compare("turned", heap.factor(at));
    Heap other = heap;
    other.cells = reversed(heap.cells);
    compare("in another order", other.factor({}));
  }
}

/** Grains under pressure and shear, some joints without any strength. */
void strengths()
{
  const Packing<3> packing = cells_in_box(60, {1., 1., 1.}, 2);
  dealii::Tensor<2, 3> pressure, shear;
  for (unsigned int i = 0; i < 3; ++i)
    pressure[i][i] = -1.;
  shear[0][1] = shear[1][0] = 1.;
  const SpaceLoads dead = tractions(packing, pressure),
                   live = tractions(packing, shear);
  for (const bool turns : {false, true})
  {
    SpaceCase of(packing);
    of.packing = packing; // which rests on nothing
    of.turns = turns;
    const auto draw = [&](const double exponent) {
      Random random(1);
      of.strengths.clear();
      for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
        of.strengths.push_back(
            random() < 0.2 ? 0.
                           : std::pow(10., exponent * (2. * random() - 1.)));
    };
    draw(6.);
    proven_factor(text("Strengths of 0, 1e-6 to 1e6", turns ? ", turning" : ""),
                  of, dead, live);
    draw(9.);
    std::cout << "Strengths of 0, 1e-9 to 1e9" << (turns ? ", turning: " : ": ")
              << proven_verdict(
                     SpaceScene(of.blocks(), together(dead, 0.01, live)))
              << std::endl;
  }
}

/**
 * A cube with a thin pillar on it, whose foot has an area of 1e-9. A low pillar
 * slides, as the cube does; a high one topples.
 */
void slivers()
{
  const double width = std::sqrt(1e-9);
  for (const double height : {1e-9, 1e-5, 1.})
    for (const bool is_dry : {false, true})
    {
      CellFaces cells;
      add_box(cells, {0., 0., 0.}, {1., 1., 1.});
      add_box(cells, {0.3, 0.4, 1.}, {0.3 + width, 0.4 + width, 1. + height});
      cells.tolerance = 1e-12;
      SpaceCase of{Packing<3>(cells)};
      of.mu = is_dry ? 0.3 : 0.;
      of.strength = is_dry ? 0. : 0.7;
      const double slides = is_dry ? 0.3 : 0.7 / (1. + width * width * height);
      const auto found = proven_factor(
          text("Pillar of the height ", height, is_dry ? ", dry" : ""), of,
          body_force(of.packing, vector(0., 0., -1.)),
          body_force(of.packing, vector(1., 0., 0.)));
      check_error("  factor",
                  std::abs(found.bound - std::min(slides, width / height)),
                  1e-9);
    }
}

/**
 * A column of drums, which rocks as one block: the resultant at half its height
 * goes through the edge of its foot.
 */
void drums()
{
  const double height = 5.;
  ColumnGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("Drums", 5L);
  prm.set("Sides", 64L);
  prm.set("Bottom radius", 0.5);
  prm.set("Top radius", 0.5);
  prm.set("Height", height);
  SpaceCase column{Packing<3>(generator.generate("", Terminal::silent()))};
  column.mu = 0.9;
  const auto foot =
      column.packing.polygon(column.packing.interfaces().size() - 1);
  check("64 vertices", foot.size() == 64);
  const Point<3> centre = column.packing.interfaces().back().centroid;
  for (const double angle : {0., 0.02, 1.})
  {
    const Vector3 push = vector(std::cos(angle), std::sin(angle), 0.);
    double to_edge = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < foot.size(); ++i)
    {
      const Vector3 a = foot[i] - centre,
                    side = foot[(i + 1) % foot.size()] - foot[i];
      const double distance =
          cross_product_3d(a, side)[2] / cross_product_3d(push, side)[2];
      if (distance > 0.)
        to_edge = std::min(to_edge, distance);
    }
    check_factor(text("Drums pushed at the angle ", angle),
                 to_edge / (0.5 * height), column,
                 body_force(column.packing, vector(0., 0., -1.)),
                 body_force(column.packing, push));
  }
}

/** A block that touches nothing: whatever is balanced on it is carried. */
void no_joints()
{
  CellFaces cells;
  add_box(cells, {0., 0., 1.}, {1., 2., 4.});
  SpaceCase of{Packing<3>(cells)};
  dealii::Tensor<2, 3> S;
  S[0][0] = -1.;
  S[0][1] = S[1][0] = 2.;
  S[2][2] = 3.;
  for (const bool turns : {false, true})
  {
    of.turns = turns;
    std::cout << "A block without joints: "
              << proven_verdict(
                     SpaceScene(of.blocks(), tractions(of.packing, S)))
              << std::endl;
  }
}

void run()
{
  invariance();
  strengths();
  slivers();
  drums();
  no_joints();
}

const RoomTest test("space_extremes", run);
} // namespace test_space_extremes
