// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_statics_space_thickness_h
#define voussoir_tests_statics_space_thickness_h

#include "space_scenes.h"
#include <functional>

// The least thickness of arches and domes, for tests.

/** Blocks of some thickness, their weight and a load on the crown. */
struct CrownLoad
{
  SpaceCase of;
  Voussoir::SpaceLoads weight, crown;
};

/**
 * Find the thickness at which no load on the crown is carried beside the
 * weight, nor needs to be lifted: the root of the greatest factor, by the
 * secant. Then prove that a little less falls and a little more stands.
 */
inline void
check_least_thickness(const std::string &name,
                      const double expected,
                      const double error,
                      const std::function<CrownLoad(double)> &blocks_of)
{
  const auto factor = [&](const double thickness) {
    const CrownLoad at = blocks_of(thickness);
    const auto blocks = at.of.blocks();
    const auto answer =
        Voussoir::find_load_factor(Voussoir::SpaceScene(blocks, at.weight),
                                   Voussoir::SpaceScene(blocks, at.crown),
                                   {true}, Voussoir::Terminal::silent());
    return answer.factor ? 0.5 * (answer.factor->carried + answer.factor->bound)
                         : 0.;
  };
  double a = 1.01 * expected, b = 1.005 * expected;
  double at_a = factor(a), at_b = factor(b);
  for (unsigned int k = 0; k < 8 && std::abs(a - b) > 1e-7 * b; ++k)
  {
    const double next = b - at_b * (b - a) / (at_b - at_a);
    a = b;
    at_a = at_b;
    b = next;
    at_b = factor(b);
  }
  check_error(name + ": least thickness", std::abs(b - expected), error);
  const CrownLoad less = blocks_of(b - 1e-8), more = blocks_of(b + 1e-8);
  check("  falls below",
        proven_factor("  less", less.of, less.weight, less.crown).bound < 0.);
  check("  stands above",
        proven_factor("  more", more.of, more.weight, more.crown).carried > 0.);
}

/**
 * check_least_thickness() of a hemispherical dome of the mean radius one, with
 * a figure of eight digits.
 */
inline void check_thickness_of_dome(const unsigned int n_courses,
                                    const unsigned int n_sectors,
                                    const double mu,
                                    const double expected)
{
  const auto blocks_of = [&](const double thickness) {
    SpaceCase of = dome(n_courses, n_sectors, thickness);
    of.mu = mu;
    const Voussoir::Packing<3> &packing = of.packing;
    unsigned int keystone = 0;
    for (unsigned int c = 0; c < packing.n_cells(); ++c)
      if (packing.centre(c)[2] > packing.centre(keystone)[2])
        keystone = c;
    Voussoir::SpaceLoads crown(packing.n_cells());
    crown.add(keystone, vector(0., 0., -packing.volume()), Vector3());
    return CrownLoad{of, body_force(packing, vector(0., 0., -1.)), crown};
  };
  check_least_thickness(
      Voussoir::text("Dome of ", n_courses, " by ", n_sectors, ", mu ", mu),
      expected, 5e-9, blocks_of);
}

#endif
