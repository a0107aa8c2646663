// SPDX-License-Identifier: LGPL-2.1-or-later

// Units do not change the nondimensional forces of any formulation: lengths and
// stresses times 1e-6 and 1e6. Nor does the smoothing length, or the modulus,
// which are units of displacement.

#include "tests.h"

namespace test_formulations_units
{
using namespace Voussoir;

/** Forces over (stress x length), of a packing that slides in places. */
InterfaceForces nondimensional_forces(const Method &method,
                                      const double length,
                                      const double stress)
{
  const Scene scene =
      scene_under_stress(random_packing(200, 1, {{0., 0.}, {length, length}}),
                         0.3 * stress, stress * tensor(-1.2, 0.1, 0.1, -0.8));
  InterfaceForces forces = Solver(method).forces(scene);
  for (auto *component : {&forces.normal, &forces.tangential})
    for (double &f : *component)
      f /= length * stress;
  return forces;
}

void compare_displacements(const Method &method,
                           const std::string &setting,
                           const double factor)
{
  const Scene scene = shear_wall(2.);
  const DiscreteProblem problem = discretise(scene);
  const auto u =
      dimensional_motion(problem, Solver(method).solve(problem)).displacement;
  const auto v =
      dimensional_motion(problem, Solver(method.with(setting)).solve(problem))
          .displacement;
  double error = 0., largest = 0.;
  for (unsigned int c = 0; c < u.size(); ++c)
  {
    error = std::max(error, (factor * v[c] - u[c]).norm());
    largest = std::max(largest, u[c].norm());
  }
  check_error(method.name + ": displacements in proportion", error / largest,
              1e-12);
}

void run()
{
  for (const Method &method : all_methods)
  {
    const InterfaceForces reference = nondimensional_forces(method, 1., 1.);
    const auto compare = [&](const std::string &what,
                             const InterfaceForces &forces) {
      check_error(what, distance(reference, forces), 1e-8);
    };
    std::cout << method.name << std::endl;
    for (const std::string factor : {"1e-6", "1e6"})
    {
      const double f = std::stod(factor);
      compare("  lengths", nondimensional_forces(method, f, 1.));
      compare("  stresses", nondimensional_forces(method, 1., f));
      compare("  both", nondimensional_forces(method, f, f));
      if (method.formulation == "smoothed friction")
        compare("  eps",
                nondimensional_forces(
                    method.with("set Smoothing length = " + factor), 1., 1.));
      if (method.formulation == "least energy")
        compare("  modulus",
                nondimensional_forces(method.with("set Modulus = " + factor),
                                      1., 1.));
    }
  }
  compare_displacements(compliant, "set Smoothing length = 1e3", 1e-3);
  compare_displacements(hard, "set Smoothing length = 1e3", 1e-3);
  compare_displacements(least_energy, "set Modulus = 1e3", 1e3);
}

const RoomTest test("formulations_units", run);
} // namespace test_formulations_units
