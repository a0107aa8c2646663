// SPDX-License-Identifier: LGPL-2.1-or-later

// What least energy selects. On Voronoi packings: every admissible uniform
// stress, whatever the strength. On any packing: a state f such that no other
// admissible and balanced state g has less energy, sum d/|e| f.(g - f) >= 0;
// also one far from uniform, in which many joints slide and open.

#include "tests.h"

namespace test_least_energy_selection
{
using namespace Voussoir;

/** sum_e d_e/|e| f_e . (g_e - f_e), over the energy of f. */
double
slope(const Scene &scene, const InterfaceForces &f, const InterfaceForces &g)
{
  double slope = 0., energy = 0.;
  for (unsigned int e = 0; e < f.normal.size(); ++e)
  {
    const auto &i = scene.packing.interfaces()[e];
    const double d = (scene.packing.centre(i.cell_plus) -
                      scene.packing.centre(i.cell_minus)) *
                     i.normal;
    const auto product = [&](const InterfaceForces &h) {
      return d / i.length *
             (f.normal[e] * h.normal[e] + f.tangential[e] * h.tangential[e]);
    };
    slope += product(g) - product(f);
    energy += product(f);
  }
  return slope / energy;
}

void compare(const std::string &what, const Scene &scene)
{
  const InterfaceForces f = Solver(least_energy).forces(scene);
  const Certificate certificate = certify(scene, f);
  std::cout << what << std::endl;
  check_error("  equilibrium", certificate.equilibrium_residual, 1e-10);
  check_error("  admissibility", certificate.admissibility_violation, 1e-12);
  check("  some joints slide", certificate.max_utilisation > 1. - 1e-12);
  for (const Method &method : all_methods)
    check_error("  energy that " + method.name + " could save",
                -slope(scene, f, Solver(method).forces(scene)), 1e-8);
}

void run()
{
  // With S symmetric or not, the latter with residual torques.
  for (const auto &[S, strength] :
       {std::make_pair(tensor(-1, 0, 0, -1), 1e-6),
        std::make_pair(tensor(-1, 0, 0, -1), 1e9),
        std::make_pair(tensor(-1.2, 0.1, 0.1, -0.8), 0.3),
        std::make_pair(tensor(-3, 1, 1, -0.4), 10.),
        std::make_pair(tensor(-1, -1, -1, -1), 2.),
        std::make_pair(tensor(-1, 0.2, -0.1, -2), 1.)})
    for (const unsigned int n : {20, 500})
    {
      const Scene scene = scene_under_stress(random_packing(n, 7), strength, S);
      check_error(
          "uniform stress, " + std::to_string(n) + " cells",
          distance_from_uniform(scene, Solver(least_energy).forces(scene), S),
          1e-9);
    }

  compare("biaxial load, sliding",
          scene_under_stress(random_packing(300, 2), 0.3,
                             tensor(-1.5, 0, 0, -0.5)));
  compare(
      "a wall of running bond",
      scene_with(wall(9, 5), 0.3,
                 [](const dealii::Point<2> &x, const dealii::Tensor<1, 2> &n) {
                   const double pi = dealii::numbers::PI;
                   dealii::Tensor<1, 2> g = -n;
                   if (x[1] > 0.5)
                     g[1] *= 1. - 0.9 * std::cos(2. * pi * x[0]);
                   return g;
                 }));

  // On a wall of running bond the line between two centres is not normal to a
  // bed joint, and uniform shear is not returned exactly.
  const auto S = tensor(-1, 0.3, 0.3, -1);
  const Scene scene = scene_under_stress(wall(6, 4), 10, S);
  const InterfaceForces forces = Solver(least_energy).forces(scene);
  check("a wall under uniform shear has other tractions",
        distance_from_uniform(scene, forces, S) > 1e-3);
  check_error("which balance", certify(scene, forces).equilibrium_residual,
              1e-10);
}

const RoomTest test("least_energy_selection", run);
} // namespace test_least_energy_selection
