// SPDX-License-Identifier: LGPL-2.1-or-later

// Arches and dry piles closely on both sides of their limit: where an interior
// point for the loads as they are finds neither forces nor a mechanism, the
// share of loads that are blended decides.

#include <voussoir/analyses/factors/load_factor.h>
#include <voussoir/analyses/state/answer.h>
#include <voussoir/statics/conic/feasible_state.h>

#include "tests.h"

namespace test_beside_the_limit
{
using namespace Voussoir;
using dealii::Tensor;

/** An arch under its weight and a push; with all laws in turn. */
Scene arch(const unsigned int n, const double weight, const double push)
{
  const Packing<2> packing = on_ground(semicircle(n, 0.1 + 0.01 * n));
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    loads.body.add(packing, c, packing.area(c) * Tensor<1, 2>({push, -weight}));
  const std::size_t n_joints = packing.interfaces().size();
  Scene scene(packing, std::vector<double>(n_joints, n % 3 == 0 ? 1. : 0.01),
              loads, rotations());
  if (n % 3 == 0)
    scene.tensile_strength.assign(n_joints, 0.005);
  else
    scene.coefficient.assign(n_joints, 0.7);
  if (n % 3 == 1)
    scene.compressive_strength.assign(n_joints, 30.);
  return scene;
}

/** Whether the loads are carried, by analyse(). */
std::string verdict(const Scene &scene)
{
  SolverRecord record;
  dealii::TimerOutput timer(std::cout, dealii::TimerOutput::never,
                            dealii::TimerOutput::wall_times);
  try
  {
    const Answer answer =
        analyse(scene, FeasibleState(), {}, record, timer, Terminal::silent());
    return std::holds_alternative<Carried>(answer) ? "carried" : "collapse";
  }
  catch (const SolverError &error)
  {
    return error.what();
  }
}

/**
 * A dry pile on its base, drawn at an angle from the vertical: whatever its
 * weight it slides in its beds, or does not. There is no factor between.
 */
void check_pile(const Packing<2> &pile, const double mu, const double distance)
{
  const auto is = [&](const double tangent, const std::string &wanted) {
    Loads loads;
    loads.traction.resize(pile.boundary_edges().size());
    for (unsigned int c = 0; c < pile.n_cells(); ++c)
      loads.body.add(pile, c, pile.area(c) * Tensor<1, 2>({tangent, -1.}));
    const std::size_t n_joints = pile.interfaces().size();
    Scene scene(pile, std::vector<double>(n_joints, 0.), loads);
    scene.coefficient.assign(n_joints, mu);
    return verdict(scene) == wanted;
  };
  check("a pile of " + std::to_string(pile.n_cells()) + " bricks",
        is(mu * (1. - distance), "carried") &&
            is(mu * (1. + distance), "collapse"));
}

void run()
{
  for (const unsigned int n : {8, 9, 10, 11, 12})
  {
    LoadFactorControls controls;
    controls.tolerance = 1e-10;
    const LoadFactor factor =
        *find_load_factor(arch(n, 1., 0.), arch(n, 0., 1.), controls,
                          Terminal::silent())
             .factor;
    for (const double distance : {1e-4, 1e-6, 1e-8})
    {
      // Factors of sections that crush are proven to some units of 1e-9.
      if (n % 3 == 1 && distance < 1e-7)
        continue;
      const Scene within = arch(n, 1., factor.carried * (1. - distance)),
                  beyond = arch(n, 1., factor.bound * (1. + distance));
      const std::string inside = verdict(within), outside = verdict(beyond);
      check(std::to_string(n) + " voussoirs",
            inside == "carried" && outside == "collapse");
    }
  }
  for (const unsigned int n_courses : {1, 3, 8})
    for (const double distance : {1e-3, 1e-6, 1e-8})
      check_pile(on_ground(wall(n_courses, 3)), 0.2123, distance);
}

const RoomTest test("beside_the_limit", run);
} // namespace test_beside_the_limit
