// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_statics_coulomb_scenes_h
#define tests_statics_coulomb_scenes_h

#include "tests.h"

/** A packing on the ground under a body force, with Coulomb's friction. */
inline Voussoir::Scene under(const Voussoir::Packing<2> &packing,
                             const dealii::Tensor<1, 2> &force,
                             const double mu,
                             const double cohesion)
{
  Voussoir::Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    loads.body.add(packing, c, packing.area(c) * force);
  const std::size_t n = packing.interfaces().size();
  Voussoir::Scene scene(packing, std::vector<double>(n, cohesion), loads,
                        Voussoir::rotations());
  if (mu > 0.)
    scene.coefficient.assign(n, mu);
  return scene;
}

/** A wall of bricks of 0.4 by 0.175 on the ground. */
inline Voussoir::Scene wall_under(const unsigned int n_courses,
                                  const unsigned int n_bricks,
                                  const double fx,
                                  const double fy,
                                  const double mu,
                                  const double cohesion)
{
  return under(
      on_ground(wall(n_courses, n_bricks, 0.4 * n_bricks, 0.175 * n_courses)),
      dealii::Tensor<1, 2>({fx, fy}), mu, cohesion);
}

#endif
