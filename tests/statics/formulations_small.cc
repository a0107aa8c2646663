// SPDX-License-Identifier: LGPL-2.1-or-later

// Every formulation at the small end, without friction, without load, with
// strengths that differ by joint, and with groups of cells that do not touch.

#include "tests.h"

namespace test_formulations_small
{
using namespace Voussoir;

void solve(const std::string &what, const Scene &scene)
{
  std::cout << what << std::endl;
  for (const Method &method : all_methods)
  {
    const InterfaceForces forces = Solver(method).forces(scene);
    const Certificate certificate = certify(scene, forces);
    check_error("  " + method.name,
                std::max(certificate.equilibrium_residual,
                         certificate.admissibility_violation),
                1e-8);
  }
}

/** Two rows of two unit squares, one above the other with a gap between. */
Packing<2> two_groups()
{
  CellLoops cells;
  for (const double y : {0., 3.})
  {
    const unsigned int first = cells.vertices.size();
    for (const double x : {0., 1., 2.})
      for (const double height : {0., 1.})
        cells.vertices.emplace_back(x, y + height);
    for (const unsigned int left : {0, 2})
    {
      for (const unsigned int corner : {0, 2, 3, 1})
        cells.loops.push_back(first + left + corner);
      cells.first.push_back(cells.loops.size());
    }
  }
  return Packing<2>(std::move(cells));
}

void run()
{
  const auto pressure = tensor(-1, 0, 0, -1);
  for (const unsigned int n : {1, 2, 3})
    solve(std::to_string(n) + " cells",
          scene_under_stress(random_packing(n, 1), 1, pressure));
  solve("no friction", scene_under_stress(random_packing(40, 2), 0, pressure));
  solve("no load", scene_under_stress(random_packing(40, 2), 1, 0. * pressure));
  solve("neither", scene_under_stress(random_packing(40, 2), 0, 0. * pressure));
  solve(
      "one column of a wall is loaded",
      scene_with(wall(3, 4), 1,
                 [](const dealii::Point<2> &x, const dealii::Tensor<1, 2> &n) {
                   return x[0] < 0.25 ? -std::abs(n[1]) * n : 0. * n;
                 }));

  // Strengths that differ from joint to joint, some of them zero.
  Scene scene =
      scene_under_stress(random_packing(40, 2), 1, tensor(-1, 0.05, 0.05, -1));
  for (unsigned int e = 0; e < scene.strength.size(); ++e)
    scene.strength[e] = (e % 3) * std::pow(10., e % 5);
  solve("strengths from 0 to 2e4", scene);

  // Each group carries a load of its own: 1 below and 2 above.
  const Scene groups =
      scene_with(two_groups(), 1,
                 [](const dealii::Point<2> &x, const dealii::Tensor<1, 2> &n) {
                   return (x[1] > 2. ? -2. : -1.) * n;
                 });
  solve("two groups", groups);
  for (const Method &method : all_methods)
  {
    const InterfaceForces forces = Solver(method).forces(groups);
    check_error(method.name + ": normal forces",
                std::abs(forces.normal[0] + 1.) +
                    std::abs(forces.normal[1] + 2.),
                1e-8);
  }
}

const RoomTest test("formulations_small", run);
} // namespace test_formulations_small
