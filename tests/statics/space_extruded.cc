// SPDX-License-Identifier: LGPL-2.1-or-later

// A scene in the plane that is extruded has the same answers in space, times
// the thickness: load factors of random cells and walls with all laws, with
// blocks that turn and that do not; and it does not matter how it stands, in
// which order its cells come, or in which units it is.

#include "extruded_scenes.h"
#include <random>

namespace test_space_extruded
{
using namespace Voussoir;

/** The greatest factor, with proofs as near to each other as can be. */
const LoadFactorControls as_near = {true, 1e-11};

LoadFactor factor_in_plane(const Packing<2> &packing, const Laws &laws)
{
  const auto answer = find_load_factor(scene_in_plane(packing, laws, laws.dead),
                                       scene_in_plane(packing, laws, laws.live),
                                       as_near, Terminal::silent());
  return answer.factor ? *answer.factor : LoadFactor();
}

void compare_with_the_plane()
{
  std::mt19937 generator(4);
  const auto random = [&](const double a, const double b) {
    return a + (b - a) * (generator() / double(std::mt19937::max()));
  };
  unsigned int n_compared = 0;
  double difference = 0.;
  for (unsigned int k = 0; k < 100; ++k)
  {
    const Packing<2> packing =
        on_foot(k % 2 == 0 ? random_packing(8 + k % 24, k + 1)
                           : wall(3 + k % 3, 3, 2., 1.));
    const bool is_dry = k % 3 == 0;
    Laws laws = {is_dry ? 0. : random(0.1, 2.),
                 k % 3 == 1 ? 0. : 0.6,
                 k % 3 == 2 && k % 4 > 1 ? 0.1 : 0.,
                 k % 4 < 3,
                 {},
                 {}};
    laws.dead[1] = -1.;
    laws.live[0] = random(-1., 1.);
    laws.live[1] = random(-0.2, 0.5);
    const LoadFactor plane = factor_in_plane(packing, laws);
    const SpaceCase of = in_space(packing, laws);
    const auto answer = find_load_factor(
        SpaceScene(of.blocks(), body_force(of.packing, upright(laws.dead))),
        SpaceScene(of.blocks(), body_force(of.packing, upright(laws.live))),
        as_near, Terminal::silent());
    const bool both = answer.factor.has_value() == !plane.forces.empty();
    if (!both ||
        (answer.factor && answer.factor->is_unbounded != plane.is_unbounded))
      std::cout << "scene " << k << " FAILED" << std::endl;
    if (!answer.factor || plane.is_unbounded)
      continue;
    ++n_compared;
    difference =
        std::max(difference, std::abs(answer.factor->bound / plane.bound - 1.));
  }
  check("scenes with a factor", n_compared > 60);
  check_error("difference of factors", difference, 1e-9);
}

/** A heap of grains on the ground, as it is and otherwise. */
void invariance()
{
  const Packing<2> wall_in_plane = wall(4, 3, 2., 1.);
  Laws laws = {0.05, 0.5, 0., true, {}, {}};
  CellFaces cells = extruded(wall_in_plane);
  const auto factor = [&](CellFaces of, const auto &map, const double unit,
                          const double stress) {
    for (dealii::Point<3> &centre : of.centres)
      centre = map(centre);
    of = mapped(std::move(of), map);
    of.tolerance = 1e-9 * unit;
    Packing<3> packing(of);
    std::vector<bool> at_foot;
    const auto direction = [&](const Vector3 &v) {
      return Vector3(map(dealii::Point<3>(v)) - map(dealii::Point<3>())) / unit;
    };
    const Vector3 down = direction(vector(0., 0., -1.)),
                  side = direction(vector(1., 0.3, 0.));
    for (const auto &face : packing.boundary_faces())
      at_foot.push_back(std::abs((face.centroid - map(dealii::Point<3>())) *
                                 down) < 1e-6 * unit &&
                        face.normal * down > 0.5);
    SpaceCase result(packing);
    result.packing = packing;
    result.packing.support(at_foot);
    result.strength = laws.strength * stress;
    result.mu = laws.mu;
    const double b = stress / unit;
    const auto found = find_load_factor(
        SpaceScene(result.blocks(), body_force(result.packing, b * down)),
        SpaceScene(result.blocks(), body_force(result.packing, b * side)),
        as_near, Terminal::silent());
    return found.factor ? found.factor->bound : 0.;
  };
  const auto identity = [](const dealii::Point<3> &p) { return p; };
  const double expected = factor(cells, identity, 1., 1.);
  check("a factor", expected > 0.);
  const auto compare = [&](const std::string &what, const double found,
                           const double error) {
    check_error(what, std::abs(found / expected - 1.), error);
  };
  const double a = 0.7, b = 1.1;
  const auto turned = [&](const dealii::Point<3> &p) {
    const double x = std::cos(a) * p[0] - std::sin(a) * p[1],
                 y = std::sin(a) * p[0] + std::cos(a) * p[1];
    return dealii::Point<3>(x, std::cos(b) * y - std::sin(b) * p[2],
                            std::sin(b) * y + std::cos(b) * p[2]);
  };
  compare("turned", factor(cells, turned, 1., 1.), 1e-8);
  const auto moved = [](const dealii::Point<3> &p) {
    return p + dealii::Point<3>(1e4, -2e4, 1e4);
  };
  compare("moved far away", factor(cells, moved, 1., 1.), 1e-6);
  for (const double unit : {1e-9, 1e-3, 1e3, 1e9})
  {
    const auto scaled = [unit](const dealii::Point<3> &p) {
      return dealii::Point<3>(unit * p);
    };
    compare("in other units", factor(cells, scaled, unit, 1e3 * unit), 1e-8);
  }
}

/** Grains under a uniform stress: the tractions are those of the stress. */
void uniform_stress()
{
  dealii::Tensor<2, 3> S;
  S[0][0] = -1.;
  S[1][1] = -1.3;
  S[2][2] = -0.8;
  S[0][1] = S[1][0] = 0.2;
  S[1][2] = S[2][1] = -0.1;
  for (const bool turns : {false, true})
    for (const double mu : {0., 0.8})
    {
      SpaceCase of{Packing<3>(extruded(random_packing(60, 5)))};
      of.packing = Packing<3>(extruded(random_packing(60, 5)));
      of.turns = turns;
      of.mu = mu;
      of.strength = mu > 0. ? 0. : 1.;
      check_uniform_stress(
          text("uniform stress, ", turns ? "turning, " : "", "mu ", mu), of, S);
    }
}

void run()
{
  compare_with_the_plane();
  invariance();
  uniform_stress();
}

const RoomTest test("space_extruded", run);
} // namespace test_space_extruded
