// SPDX-License-Identifier: LGPL-2.1-or-later

// States of least energy in space against the stress that is known: Voronoi
// cells under tractions of any uniform stress, with all laws; a column under
// its weight, of slabs that lie askew and of Voronoi cells.

#include <voussoir/packing/polyhedra/generators/block_builder.h>

#include "space_scenes.h"

namespace test_space_uniform_stress
{
using namespace Voussoir;
using dealii::Point;

void uniform_stress()
{
  const Packing<3> packing = cells_in_box(300, {1., 1., 1.}, 1);
  Random random(1);
  for (const bool turns : {false, true})
    for (unsigned int k = 0; k < 3; ++k)
    {
      SpaceCase of(packing);
      of.packing = packing; // which rests on nothing
      of.turns = turns;
      of.strength = of.tension = 10.;
      check_uniform_stress(text("Any stress ", k, turns ? ", turning" : ""), of,
                           random_stress(random, 0.));
      of.strength = of.tension = 0.;
      of.mu = 1.;
      check_uniform_stress(
          text("Pressure and shear ", k, turns ? ", turning" : ""), of,
          random_stress(random, 5.));
    }
}

/** The state of a column under its weight, of the density one. */
FaceForces state_of_column(const SpaceScene &scene)
{
  const FaceForces forces = elastic_forces(scene);
  check_error("  balance", certify(scene, forces).error(), 1e-12);
  return forces;
}

/**
 * The largest difference of what joints use of the strength gamma H from what
 * they use of it below the weight of what is straight above them: with the
 * angle a to the horizontal, at the height z, (1 - z/H) sin a cos a.
 */
double difference_of_utilisation(const SpaceCase &column, const double height)
{
  const SpaceScene scene(column.blocks(),
                         body_force(column.packing, vector(0., 0., -1.)));
  const FaceForces forces = elastic_forces(scene);
  check_error("  balance", certify(scene, forces).error(), 1e-12);
  double difference = 0.;
  for (unsigned int e = 0; e < column.packing.interfaces().size(); ++e)
  {
    const auto &joint = column.packing.interfaces()[e];
    const double cosine = std::min(1., std::abs(joint.normal[2]));
    const double expected = (1. - joint.centroid[2] / height) * cosine *
                            std::sqrt(1. - cosine * cosine);
    difference = std::max(
        difference,
        std::abs(utilisation_of_face(*scene.blocks, forces, e) - expected));
  }
  return difference;
}

/** Slabs between parallel planes, whose weight goes through all centroids. */
void column_of_slabs()
{
  const unsigned int n = 5;
  const double thickness = 0.3, height = n * thickness;
  for (const double slope : {0.4, 1.})
  {
    BlockBuilder builder({"slab"});
    for (unsigned int k = 0; k < n; ++k)
    {
      std::array<Point<3>, 8> corners;
      for (unsigned int v = 0; v < 8; ++v)
      {
        const double x = v & 1 ? 0.5 : -0.5, level = v & 4 ? k + 1. : k;
        corners[v] =
            Point<3>(x, v & 2 ? 0.7 : 0., slope * x + thickness * level);
      }
      builder.add_hexahedron(corners, 0);
    }
    SpaceCase column{Packing<3>(builder.take())};
    column.strength = height;
    std::cout << "Slabs with the slope " << slope << std::endl;
    check("  on one support", column.packing.n_supports() == 1);
    check_error("  utilisation", difference_of_utilisation(column, height),
                1e-12);
  }
}

/** Voronoi cells, whose least energy is that of the linear stress but nearly.*/
void column_of_cells()
{
  const double height = 4.;
  SpaceCase column(cells_in_box(300, {1., 1., height}, 1));
  column.strength = height;
  std::cout << "Voronoi cells" << std::endl;
  check_error("  utilisation", difference_of_utilisation(column, height), 0.02);
}

void run()
{
  uniform_stress();
  column_of_slabs();
  column_of_cells();
}

const RoomTest test("space_uniform_stress", run);
} // namespace test_space_uniform_stress
