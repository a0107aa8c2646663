// SPDX-License-Identifier: LGPL-2.1-or-later

// Packings at the small end, without friction, and without load.

#include "tests.h"

using namespace Voussoir;

void solve(const std::string &what, const Scene &scene)
{
  std::cout << what << std::endl;
  for (const std::string &contact : {compliant, hard})
  {
    const InterfaceForces forces = Solver(contact).forces(scene);
    const Certificate certificate = certify(scene, forces);
    check_error("  " + contact + ": equilibrium",
                certificate.equilibrium_residual, 1e-8);
    check_error("  " + contact + ": admissibility",
                certificate.admissibility_violation, 1e-8);
  }
}

int main()
{
  const auto pressure = tensor(-1, 0, 0, -1);
  for (const unsigned int n : {1, 2, 3})
    solve(std::to_string(n) + " cells",
          scene_under_stress(random_packing(n, 1), 1, pressure));
  solve("no friction", scene_under_stress(random_packing(40, 2), 0, pressure));
  solve("no load", scene_under_stress(random_packing(40, 2), 1, 0. * pressure));
  solve("neither", scene_under_stress(random_packing(40, 2), 0, 0. * pressure));

  // Strengths that differ from joint to joint, some of them zero.
  Scene scene =
      scene_under_stress(random_packing(40, 2), 1, tensor(-1, 0.05, 0.05, -1));
  for (unsigned int e = 0; e < scene.strength.size(); ++e)
    scene.strength[e] = (e % 3) * std::pow(10., e % 5);
  solve("strengths from 0 to 2e4", scene);
}
