// SPDX-License-Identifier: LGPL-2.1-or-later

// Load factors and strength factors in space, between two proofs that are added
// up again: a block in a groove and a wedge of rock by their closed forms;
// facades that interlock with the walls behind them; a model of another
// program.

#include <voussoir/packing/polyhedra/generators/block_builder.h>
#include <voussoir/packing/polyhedra/models/model.h>

#include "space_scenes.h"

namespace test_space_answers
{
using namespace Voussoir;
using dealii::Point;

constexpr double degree = 0.017453292519943295;

/** The loads along a direction beside the weight. */
struct Pushed
{
  Pushed(SpaceCase of, const Vector3 &direction)
      : of(std::move(of)),
        weight(body_force(this->of.packing, vector(0., 0., -1.))),
        push(body_force(this->of.packing, direction))
  {}
  SpaceCase of;
  SpaceLoads weight, push;
};

/** A long prism along x in a groove, whose sides are at the angle b to z. */
Pushed in_groove(const double b, const double mu)
{
  const double s = std::sin(b), c = std::cos(b);
  const auto section = [s, c](const double x) {
    return BlockBuilder::Loop{{x, 0., 0.5}, {x, s, 0.5 + c}, {x, -s, 0.5 + c}};
  };
  BlockBuilder builder({"block"});
  builder.add_frustum(section(0.), section(40.), 0);
  SpaceCase of{Packing<3>(builder.take())};
  of.support([](const auto &face) { return face.normal[2] < -1e-6; });
  of.mu = mu;
  return {of, vector(1., 0., 0.)};
}

/**
 * A block that slides with dilatancy opens both sides of the groove, so that it
 * climbs out: at mu / sqrt(sin^2 b - mu^2 cos^2 b), and from mu = tan b on no
 * factor is too large.
 */
void grooves()
{
  for (const double angle : {20., 45., 70.})
  {
    const double b = angle * degree;
    for (const double share : {0.2, 0.7, 0.9999})
    {
      const double mu = share * std::tan(b);
      const double s = std::sin(b), c = std::cos(b);
      const Pushed block = in_groove(b, mu);
      check_factor(text("Groove of ", angle, " degrees, mu ", mu),
                   mu / std::sqrt(s * s - mu * mu * c * c), block.of,
                   block.weight, block.push);
    }
    for (const double share : {1.0001, 1.5})
    {
      const double mu = share * std::tan(b);
      const Pushed block = in_groove(b, mu);
      const auto found =
          proven_factor(text("Groove of ", angle, " degrees, mu ", mu),
                        block.of, block.weight, block.push);
      check("  unbounded", found.is_unbounded);
    }
  }
}

/** The upward normal of a plane that dips to an azimuth; y is north. */
Vector3 normal_of(const double dip, const double azimuth)
{
  const double s = std::sin(dip * degree);
  return vector(s * std::sin(azimuth * degree), s * std::cos(azimuth * degree),
                std::cos(dip * degree));
}

/** A plane by its normal and a point on it. */
struct Plane
{
  Vector3 normal;
  Point<3> point;
};

/** The point on three planes. */
Point<3> common_point(const Plane &a, const Plane &b, const Plane &c)
{
  const Vector3 bc = cross_product_3d(b.normal, c.normal),
                ca = cross_product_3d(c.normal, a.normal),
                ab = cross_product_3d(a.normal, b.normal);
  return Point<3>(((a.normal * a.point) * bc + (b.normal * b.point) * ca +
                   (c.normal * c.point) * ab) /
                  (a.normal * bc));
}

/**
 * A wedge of rock on two planes, with the dips 40 and 60 degrees to the
 * azimuths 130 and 220. With dilatancy it slides if there is a v with v . n >=
 * |v| sin phi for both normals on which the weight does work; at the critical
 * angle v is horizontal, and since the azimuths are 90 degrees apart it has
 *
 *     sin phi = sin 40 sin 60 / sqrt(sin^2 40 + sin^2 60), phi = 31.0743.
 */
void rock_wedge()
{
  const Vector3 a = normal_of(40., 130.), b = normal_of(60., 220.);
  const Point<3> toe(1., 1., 1.), crest(1., 1., 2.);
  const Plane below_a{a, toe}, below_b{b, toe},
      slope{normal_of(80., 180.), toe}, top{vector(0., 0., 1.), crest};
  BlockBuilder builder({"wedge"});
  builder.add_polyhedron({toe, common_point(below_a, below_b, top),
                          common_point(below_a, slope, top),
                          common_point(below_b, slope, top)},
                         {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}, 0);
  SpaceCase wedge{Packing<3>(builder.take())};
  wedge.support([&](const auto &face) {
    return face.normal * a < -0.999 || face.normal * b < -0.999;
  });
  wedge.mu = 0.9;
  const double sin_a = std::sin(40. * degree), sin_b = std::sin(60. * degree);
  const double critical = std::asin(sin_a * sin_b / std::hypot(sin_a, sin_b));
  check_error("Critical angle of friction",
              std::abs(critical / degree - 31.0743), 5e-5);
  for (const bool turns : {false, true})
  {
    wedge.turns = turns;
    check_strength_factor(
        text("Wedge that ", turns ? "turns" : "does not turn"),
        wedge.mu / std::tan(critical), wedge,
        body_force(wedge.packing, vector(0., 0., -1.)));
  }
}

/**
 * A facade along x and walls behind both of its ends, of bricks 2 x 1 x 1 that
 * interlock: the corners are the ends of the facade in even courses, and those
 * of the walls in odd ones. There the walls end in whole bricks, else in half
 * ones.
 */
SpaceCase facade(const unsigned int n_bricks,
                 const unsigned int n_behind,
                 const unsigned int n_courses)
{
  const double length = 2. * n_bricks, depth = 2. * n_behind;
  CellFaces cells;
  for (unsigned int k = 0; k < n_courses; ++k)
  {
    const double z = k, shift = k % 2;
    for (double x = shift; x < length - shift; x += 2.)
      add_box(cells, {x, 0., z}, {x + 2., 1., z + 1.});
    for (const double x : {0., length - 1.})
      for (double y = 1. - shift; y < depth; y += 2.)
        add_box(cells, {x, y, z}, {x + 1., std::min(y + 2., depth), z + 1.});
  }
  cells.tolerance = 1e-9;
  return SpaceCase(Packing<3>(cells));
}

void facades()
{
  struct Facade
  {
    unsigned int n_bricks, n_behind, n_courses, n_blocks;
    double factor;
  };
  for (const Facade &of :
       {Facade{3, 2, 6, 39, 0.39976387}, Facade{4, 3, 10, 95, 0.33258493},
        Facade{6, 3, 16, 184, 0.19805725}})
  {
    SpaceCase blocks = facade(of.n_bricks, of.n_behind, of.n_courses);
    blocks.mu = 0.6;
    check("Blocks", blocks.packing.n_cells() == of.n_blocks);
    const Pushed outwards(blocks, vector(0., -1., 0.));
    // The factors have eight digits.
    check_factor("Facade pushed outwards", of.factor, blocks, outwards.weight,
                 outwards.push, 3e-8);
  }
}

/** A wall along a curve, with the contacts at faces that meet exactly. */
void curved_wall()
{
  ModelGenerator generator;
  dealii::ParameterHandler prm;
  generator.add_parameters(prm);
  prm.set("File", SOURCE_DIR "/../packing/models/model_wall_curved.obj");
  prm.set("Tolerance", 1e-6);
  SpaceCase wall{Packing<3>(generator.generate("", Terminal::silent()))};
  wall.support([](const auto &face) {
    return face.normal[2] < -0.5 && face.centroid[2] < 1e-6;
  });
  wall.mu = 0.6;
  const Pushed along(wall, vector(1., 0., 0.)),
      across(wall, vector(0., 1., 0.));
  check_factor("Curved wall, along x", 0.6, wall, along.weight, along.push);
  check_factor("Curved wall, along y", 0.2533405, wall, across.weight,
               across.push, 2e-7);
}

void run()
{
  grooves();
  rock_wedge();
  facades();
  curved_wall();
}

const RoomTest test("space_answers", run);
} // namespace test_space_answers
