// SPDX-License-Identifier: LGPL-2.1-or-later

// The certificate of the exact forces of a uniform stress is clean, and sees
// one force, one sign, one strength and one NaN that are wrong.

#include "tests.h"

using namespace Voussoir;

void show(const std::string &what, const Certificate &c)
{
  std::cout << what << ": equilibrium "
            << (c.equilibrium_residual <= 1e-12 ? "holds" : "fails")
            << ", admissibility "
            << (c.admissibility_violation <= 1e-12 ? "holds" : "fails")
            << ", utilisation "
            << (c.max_utilisation <= 1. + 1e-12 ? "at most 1" : "above 1")
            << ", torque " << (c.max_torque <= 1e-12 ? "none" : "left")
            << std::endl;
}

int main()
{
  const auto S = tensor(-2, 0.3, 0.3, -1);
  Scene scene = scene_under_stress(random_packing(50, 3), 0.7, S);
  InterfaceForces exact;
  for (const auto &i : scene.packing.interfaces())
  {
    exact.normal.push_back(i.length * (S * i.normal * i.normal));
    exact.tangential.push_back(i.length * (S * i.normal * i.tangent()));
  }
  show("exact", certify(scene, exact));

  // The largest force, so that every change can be seen.
  unsigned int e = 0;
  for (unsigned int k = 0; k < exact.normal.size(); ++k)
    if (std::abs(exact.tangential[k]) > std::abs(exact.tangential[e]))
      e = k;

  InterfaceForces forces = exact;
  forces.normal[e] *= 1. + 1e-6;
  show("one normal force", certify(scene, forces));

  forces = exact;
  forces.tangential[e] *= -1.;
  show("one sign", certify(scene, forces));

  forces = exact;
  forces.normal[e] *= -1.;
  show("one tension", certify(scene, forces));

  forces = exact;
  forces.tangential[e] = std::numeric_limits<double>::quiet_NaN();
  show("one NaN", certify(scene, forces));

  scene.strength[e] = 0.9 * std::abs(exact.tangential[e]) /
                      scene.packing.interfaces()[e].length;
  show("one strength", certify(scene, exact));

  std::swap(scene.load[0], scene.load[1]);
  show("one load", certify(scene, exact));

  // The measures are relative: units change nothing.
  Scene kilo = scene_under_stress(random_packing(50, 3, {{0, 0}, {1000, 1000}}),
                                  0.7e3, 1e3 * S);
  InterfaceForces kilo_forces = exact;
  for (unsigned int k = 0; k < exact.normal.size(); ++k)
  {
    kilo_forces.normal[k] *= 1e6;
    kilo_forces.tangential[k] *= 1e6 * (k == e ? 1.001 : 1.);
  }
  forces = exact;
  forces.tangential[e] *= 1.001;
  const Scene same = scene_under_stress(random_packing(50, 3), 0.7, S);
  check_error("units do not matter",
              std::abs(certify(kilo, kilo_forces).equilibrium_residual /
                           certify(same, forces).equilibrium_residual -
                       1.),
              1e-9);
}
