// SPDX-License-Identifier: LGPL-2.1-or-later

// Some hundred to some thousand blocks in space: load factors of a wall of
// bricks along itself, out of its plane and between, and the least thickness of
// a dome, with both proofs; and the uniform stress of Voronoi cells.

#include <deal.II/base/multithread_info.h>

#include "space_thickness.h"

namespace test_space_large
{
using namespace Voussoir;

/** A wall of n courses of n bricks, or n - 1 and two halves in even ones. */
SpaceCase running_bond(const unsigned int n)
{
  const double length = 0.4, height = 0.175, thickness = 0.2;
  CellFaces cells;
  for (unsigned int k = 0; k < n; ++k)
  {
    const double z = height * k, shift = k % 2 == 0 ? 0.5 : 0.;
    for (unsigned int i = 0; i < n + (k + 1) % 2; ++i)
      add_box(cells, {length * std::max(0., i - shift), 0., z},
              {length * std::min(1. * n, i + 1 - shift), thickness,
               height * (k + 1)});
  }
  cells.tolerance = 1e-9;
  return SpaceCase(Packing<3>(cells));
}

void wall_of_1040()
{
  SpaceCase wall = running_bond(32);
  wall.mu = 0.65;
  check("Bricks", wall.packing.n_cells() == 1040);
  const SpaceLoads weight = body_force(wall.packing, vector(0., 0., -1.));
  // It topples as a whole about its edge: thickness over height.
  check_factor("Wall, out of plane", 1. / 28., wall, weight,
               body_force(wall.packing, vector(0., 1., 0.)));
  check_factor("Wall, askew", 5. / 28., wall, weight,
               body_force(wall.packing, vector(1., 0.2, 0.)));
  // The figure has nine digits.
  check_factor("Wall, in plane", 0.464807962, wall, weight,
               body_force(wall.packing, vector(1., 0., 0.)), 4e-9);
}

/** All cores do what one does, to the last bit, with more cones than a chunk.
 */
void threads()
{
  SpaceCase wall = running_bond(14);
  wall.mu = 0.65;
  const auto find = [&] {
    return proven_factor("Wall of 203 bricks", wall,
                         body_force(wall.packing, vector(0., 0., -1.)),
                         body_force(wall.packing, vector(1., 0.1, 0.)));
  };
  const auto by_all = find();
  const unsigned int before = dealii::MultithreadInfo::n_threads();
  dealii::MultithreadInfo::set_thread_limit(1);
  const auto by_one = find();
  dealii::MultithreadInfo::set_thread_limit(before);
  check("  the same factor by one thread",
        by_one.carried == by_all.carried && by_one.bound == by_all.bound &&
            by_one.n_iterations == by_all.n_iterations);
}

void grains()
{
  const Packing<3> packing = cells_in_box(3000, {1., 1., 1.}, 1);
  Random random(1);
  SpaceCase of(packing);
  of.packing = packing; // which rests on nothing
  of.strength = of.tension = 10.;
  check_uniform_stress("Any stress", of, random_stress(random, 0.));
  of.strength = of.tension = 0.;
  of.mu = 1.;
  check_uniform_stress("Pressure and shear", of, random_stress(random, 5.));
}

void run()
{
  wall_of_1040();
  threads();
  check_thickness_of_dome(20, 16, 0.5, 0.04263562);
  grains();
}

const RoomTest test("space_large", run);
} // namespace test_space_large
