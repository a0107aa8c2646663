// SPDX-License-Identifier: LGPL-2.1-or-later

// Strengths at 1 + 10^-k and 1 - 10^-k of the limit, k = 3...6, of packings up
// to 2,000 cells, one of which hardly any friction holds. Above the forces
// balance to 1e-9, below the collapse is proven. That both are so shows that
// the limit is right; it is found by the load factor, to which the
// strengths are inversely proportional.
//
// The shortage of a load that friction hardly takes part in may fall below the
// tolerance of least energy, which then finds a balance to that.

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/scene/supports.h>

#include "judgement.h"
#include "room.h"

namespace test_near_limit
{
using namespace Voussoir;

double limit_strength(const Scene &scene, const double strength)
{
  Scene bare = scene;
  bare.load.assign(scene.load.size(), {});
  bare.load_size.assign(scene.load.size(), 0.);
  LoadFactorControls controls;
  controls.tolerance = 1e-10;
  return strength / find_load_factor(bare, scene, controls, Terminal::silent())
                        .factor->carried;
}

/** @p scene_at gives the scene of a strength, of which @p near is one. */
void approach(const std::string &name,
              const std::function<Scene(double)> &scene_at,
              const double near)
{
  const double limit = limit_strength(scene_at(near), near);
  std::cout << name << std::endl;
  for (const Method &method : {compliant, least_energy})
    for (int k = 3; k <= 6; ++k)
      for (const double sign : {1., -1.})
      {
        const Judgement found =
            judge(scene_at(limit * (1. + sign * std::pow(10., -k))), method);
        const std::string strength =
            std::string(sign > 0. ? "1 + 1e-" : "1 - 1e-") + std::to_string(k);
        const std::string what = "  " + method.name + " at " + strength;
        if (sign > 0.)
          check(what + ": carried, residual at most 1e-9",
                found.verdict == Verdict::carried && found.error <= 1e-9);
        else
          check(what + ": collapse",
                found.verdict == Verdict::collapse ||
                    (method.name == "least energy" && k == 6 &&
                     found.verdict == Verdict::carried &&
                     found.error <= 1e-10));
      }
}

/** Under weight and horizontal tractions on the left, held at the bottom. */
Scene pushed(Packing<2> packing, const double strength)
{
  packing.support(boundary_edges_where(packing, "ny < -0.99 && y < 1e-9", ""));
  Loads loads;
  for (const auto &edge : packing.boundary_edges())
    loads.traction.push_back(edge.normal[0] < -0.99
                                 ? dealii::Tensor<1, 2>({0.3, 0.})
                                 : dealii::Tensor<1, 2>());
  loads.body = BodyForce(packing, [](const dealii::Point<2> &, unsigned int) {
    return dealii::Tensor<1, 2>({0., -1.});
  });
  const std::vector<double> strengths(packing.interfaces().size(), strength);
  return Scene(std::move(packing), strengths, std::move(loads));
}

void run()
{
  approach(
      "2,000 random cells, hardly any friction",
      [](const double strength) {
        return scene_under_stress(random_packing(2000, 5), strength,
                                  tensor(-0.7, 0.05, 0.05, -1.3));
      },
      5e-4);
  approach(
      "2,000 random cells, much friction",
      [](const double strength) {
        return scene_under_stress(random_packing(2000, 2), strength,
                                  tensor(-0.3, 0., 0., -1.7));
      },
      0.3);
  approach(
      "500 random cells",
      [](const double strength) {
        return scene_under_stress(random_packing(500, 7), strength,
                                  tensor(-0.3, 0.2, 0.2, -1.7));
      },
      0.1);
  approach(
      "a wall under weight and push",
      [](const double strength) { return pushed(wall(30, 12), strength); },
      0.3);
  approach(
      "800 random cells on a support, under weight and push",
      [](const double strength) {
        return pushed(random_packing(800, 3), strength);
      },
      0.3);
}

const RoomTest test("near_limit", run);
} // namespace test_near_limit
