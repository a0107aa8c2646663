// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_statics_extruded_scenes_h
#define voussoir_tests_statics_extruded_scenes_h

#include "space_scenes.h"
#include <vector>

// Scenes in the plane, and the same of some thickness in space.

constexpr double thickness = 0.3;

/** Prisms between y = 0 and y = thickness, whose z is the plane's y. */
inline Voussoir::CellFaces extruded(const Voussoir::Packing<2> &packing)
{
  Voussoir::CellFaces cells;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    std::vector<dealii::Point<2>> base;
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      base.push_back(packing.vertex(c, i));
    add_prism(cells, base, -thickness, 0.);
    const dealii::Point<2> &x = packing.centre(c);
    cells.centres.emplace_back(x[0], x[1], -0.5 * thickness);
  }
  // (x, y, z) to (x, -z, y) keeps the orientation.
  const auto turn = [](const dealii::Point<3> &p) {
    return dealii::Point<3>(p[0], -p[2], p[1]);
  };
  cells = mapped(std::move(cells), turn);
  for (dealii::Point<3> &centre : cells.centres)
    centre = turn(centre);
  cells.tolerance = 1e-9;
  return cells;
}

/** The laws of a scene, and the loads on it. */
struct Laws
{
  double strength, mu, tension;
  bool turns;
  dealii::Tensor<1, 2> dead, live;
};

/** The scene in the plane with the body force @p b. */
inline Voussoir::Scene scene_in_plane(const Voussoir::Packing<2> &packing,
                                      const Laws &laws,
                                      const dealii::Tensor<1, 2> &b)
{
  Voussoir::Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    loads.body.add(packing, c, packing.area(c) * b);
  const std::size_t n = packing.interfaces().size();
  Voussoir::Scene result(packing, std::vector<double>(n, laws.strength), loads,
                         laws.turns ? Voussoir::rotations()
                                    : Voussoir::translations());
  if (laws.mu > 0.)
    result.coefficient.assign(n, laws.mu);
  if (laws.tension > 0.)
    result.tensile_strength.assign(n, laws.tension);
  return result;
}

/** Cells or a wall whose foot at y = 0 is supported. */
inline Voussoir::Packing<2> on_foot(Voussoir::Packing<2> packing)
{
  std::vector<bool> at_foot;
  for (const auto &edge : packing.boundary_edges())
    at_foot.push_back(edge.midpoint()[1] < 1e-9);
  packing.support(at_foot);
  return packing;
}

/** As SpaceCase, with supports where the plane has them. */
inline SpaceCase in_space(const Voussoir::Packing<2> &packing, const Laws &laws)
{
  SpaceCase of{Voussoir::Packing<3>(extruded(packing))};
  of.strength = laws.strength;
  of.mu = laws.mu;
  of.tension = laws.tension;
  of.turns = laws.turns;
  return of;
}

inline Vector3 upright(const dealii::Tensor<1, 2> &b)
{
  return vector(b[0], 0., b[1]);
}

#endif
