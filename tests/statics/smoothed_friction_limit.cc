// SPDX-License-Identifier: LGPL-2.1-or-later

// The shear wall stands if and only if s_T >= 1: above, bed joints carry the
// shear stress 1 and no normal stress; below, the courses slide, with a ratio
// of work to dissipation of 1 / s_T. Either way it ends in few evaluations.

#include "tests.h"

using namespace Voussoir;

void try_strength(const std::string &contact, const double strength)
{
  const Scene scene = shear_wall(strength);
  const DiscreteProblem problem(scene);
  const Solution solution = Solver(contact).solve(problem);
  std::cout << contact << ", s_T = " << strength << ": ";
  if (solution.mechanism)
  {
    const auto proof =
        certify_mechanism(scene, solution.mechanism->displacement);
    std::cout << "collapse" << std::endl;
    check_error("  ratio of work to dissipation",
                std::abs(proof.work_over_dissipation * strength - 1.), 1e-9);
    check_error("  closing of joints", proof.closing_violation, 1e-14);
    check("  at most 10 evaluations", solution.n_evaluations <= 10);
    return;
  }

  std::cout << "carried" << std::endl;
  const InterfaceForces forces = dimensional_forces(problem, solution);
  const Certificate certificate = certify(scene, forces);
  check_error("  equilibrium", certificate.equilibrium_residual, 1e-6);
  check_error("  admissibility", certificate.admissibility_violation, 1e-6);
  double normal = 0., tangential = 0.;
  for (unsigned int e = 0; e < forces.normal.size(); ++e)
  {
    const auto &i = scene.packing.interfaces()[e];
    if (std::abs(i.normal[1]) < 0.5)
      continue; // a head joint
    normal = std::max(normal, std::abs(forces.normal[e]) / i.length);
    tangential = std::max(
        tangential, std::abs(std::abs(forces.tangential[e]) / i.length - 1.));
  }
  // With hard contact no state is strictly admissible: the solver approaches
  // p = 0 as the square root of its barrier parameter.
  const double tolerance = contact == hard ? 1e-3 : 1e-6;
  check_error("  normal stress of the bed joints", normal, tolerance);
  check_error("  |q|/|e| - 1 of the bed joints", tangential, tolerance);
}

int main()
{
  for (const double strength : {10., 1.5, 1.001, 1., 0.999, 0.9, 0.1})
    try_strength(compliant, strength);
  for (const double strength : {10., 1.5, 1.001, 0.999, 0.9, 0.1})
    try_strength(hard, strength);
}
