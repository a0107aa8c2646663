// SPDX-License-Identifier: LGPL-2.1-or-later

// Load factors in space, between two proofs that are added up again: closed
// forms of one block that slides, topples and twists; walls of the literature,
// in their plane, out of it and at 45 degrees; hemispherical domes.

#include "space_scenes.h"

namespace test_space_factors
{
using namespace Voussoir;

/** One box from the origin on. */
SpaceCase box(const double x, const double y, const double z)
{
  CellFaces cells;
  add_box(cells, {0., 0., 0.}, {x, y, z});
  return SpaceCase(Packing<3>(cells));
}

void one_block()
{
  for (const double slope : {0., 0.2, 0.4})
  {
    const double c = std::cos(slope), s = std::sin(slope);
    const auto loads = [&](const SpaceCase &of) {
      return std::pair(body_force(of.packing, vector(s, 0., -c)),
                       body_force(of.packing, vector(1., 0., 0.)));
    };
    SpaceCase sliding = box(1., 0.5, 0.5);
    sliding.mu = 0.6;
    auto [dead, live] = loads(sliding);
    check_factor("Incline, Coulomb", 0.6 * c - s, sliding, dead, live);
    SpaceCase toppling = box(1., 0.5, 2.);
    toppling.mu = 0.9;
    std::tie(dead, live) = loads(toppling);
    check_factor("Incline, toppling", 0.5 * c - s, toppling, dead, live);
    SpaceCase glued = box(1., 0.5, 0.5);
    glued.strength = 0.3;
    std::tie(dead, live) = loads(glued);
    check_factor("Incline, Tresca", 0.6 - s, glued, dead, live);
  }
}

/** How many times stronger a block on an incline is than it needs to be. */
void strength_factors()
{
  const double slope = 0.3, c = std::cos(slope), s = std::sin(slope);
  for (const bool is_dry : {true, false})
  {
    SpaceCase block = box(1., 0.5, 0.5);
    block.mu = is_dry ? 0.6 : 0.;
    block.strength = is_dry ? 0. : 0.4;
    const double expected = is_dry ? 0.6 * c / s : 0.4 / (0.5 * s);
    check_strength_factor("Strength factor", expected, block,
                          body_force(block.packing, vector(s, 0., -c)));
  }
}

void torsion()
{
  SpaceCase square = box(1., 1., 0.5);
  SpaceLoads torque(1), weight = body_force(square.packing, vector(0, 0, -1));
  torque.torque[0] = vector(0., 0., 1.);
  torque.size[0] = 1.;
  square.mu = 0.5;
  // All pressure at the corners: mu N a / sqrt 2.
  check_factor("Torsion, Coulomb", 0.5 * 0.5 / std::sqrt(2.), square, weight,
               torque);
  square.mu = 0.;
  square.strength = 1.;
  // The moment of a square with the same friction everywhere, from both sides.
  const double exact = (std::sqrt(2.) + std::log(1. + std::sqrt(2.))) / 6.;
  const double of_kites[] = {0.3536, 0.3744, 0.3804};
  for (unsigned int k = 0; k < 3; ++k)
  {
    square.n_cuts = 1 << k;
    const auto found = proven_factor("Torsion, Tresca", square, weight, torque);
    check_error("  kites", std::abs(found.bound - of_kites[k]), 6e-5);
    const auto blocks = square.blocks();
    const double above =
        bound_of_continuous_faces(SpaceScene(blocks, weight),
                                  SpaceScene(blocks, torque), found.mechanism)
            .factor;
    check("  below the true one", found.bound < exact);
    check_error("  and that from above", std::abs(above / exact - 1.), 1e-9);
  }
}

/** A wall of Ferris and Tin-Loi, with half bricks at the ends of odd courses.
 */
SpaceCase ferris_tin_loi(const unsigned int n_courses)
{
  const double length = 0.4, height = 0.175, thickness = 0.2;
  CellFaces cells;
  for (unsigned int k = 0; k < n_courses; ++k)
  {
    double x = 0.;
    while (x < 5. * length - 1e-9)
    {
      const bool is_half = k % 2 == 0 && (x == 0. || x > 4.4 * length);
      const double end = x + (is_half ? 0.5 * length : length);
      add_box(cells, {x, 0., k * height}, {end, thickness, (k + 1) * height});
      x = end;
    }
  }
  cells.tolerance = 1e-9;
  return SpaceCase(Packing<3>(cells));
}

void walls()
{
  const double in_plane[] = {0.642859003, 0.579998611};
  const double out_of_plane[] = {0.190476190476, 0.114285714286};
  const double of_tresca[] = {2. / 2.1, 4. / 7.};
  for (unsigned int k = 0; k < 2; ++k)
  {
    SpaceCase wall = ferris_tin_loi(k == 0 ? 6 : 10);
    const SpaceLoads weight = body_force(wall.packing, vector(0., 0., -10.));
    wall.mu = 0.65;
    check_factor("Ferris and Tin-Loi, in plane", in_plane[k], wall, weight,
                 body_force(wall.packing, vector(10., 0., 0.)));
    check_factor("Ferris and Tin-Loi, out of plane", out_of_plane[k], wall,
                 weight, body_force(wall.packing, vector(0., 10., 0.)));
    const double r = std::sqrt(0.5);
    if (k == 0)
      check_factor(
          "Ferris and Tin-Loi, at 45 degrees", 0.269374012, wall, weight,
          body_force(wall.packing, vector(10. * r, 10. * r, 0.)), 4e-9);
    wall.mu = 0.;
    wall.strength = 10.;
    check_factor("Ferris and Tin-Loi, Tresca", of_tresca[k], wall, weight,
                 body_force(wall.packing, vector(10., 0., 0.)));
  }
}

void domes()
{
  const double mu[] = {1., 0.3}, factor[] = {0.636905475, 0.167451876};
  for (unsigned int k = 0; k < 2; ++k)
  {
    SpaceCase of = dome(20, 16, 0.1);
    of.mu = mu[k];
    check_factor("Dome, horizontal body force", factor[k], of,
                 body_force(of.packing, vector(0., 0., -1.)),
                 body_force(of.packing, vector(1., 0., 0.)), 5e-9);
  }
  // The least thickness, between two domes of which one stands.
  for (const double thickness : {0.0422885, 0.0422886})
  {
    SpaceCase of = dome(10, 12, thickness);
    of.mu = 1.;
    std::cout << "Dome of the thickness " << digits(thickness) << ": "
              << proven_verdict(SpaceScene(
                     of.blocks(), body_force(of.packing, vector(0., 0., -1.))))
              << std::endl;
  }
}

void run()
{
  one_block();
  strength_factors();
  torsion();
  walls();
  domes();
}

const RoomTest test("space_factors", run);
} // namespace test_space_factors
