// SPDX-License-Identifier: LGPL-2.1-or-later

// 10,000 random cells, of which some joints are close to sliding: how many
// evaluations each formulation needs, and the certificate.

#include "tests.h"

namespace test_formulations_large
{
using namespace Voussoir;

void solve(const Method &method,
           const dealii::Tensor<2, 2> &S,
           const double strength,
           const unsigned int n_allowed)
{
  const Scene scene = scene_under_stress(random_packing(10000, 1), strength, S);
  const DiscreteProblem problem = discretise(scene);
  const Solution solution = Solver(method).solve(problem);
  const Certificate certificate =
      certify(scene, dimensional_forces(problem, solution));
  std::cout << method.name << ", strength " << strength << std::endl;
  check_error("  evaluations", solution.n_evaluations, n_allowed);
  check_error("  equilibrium", certificate.equilibrium_residual, 1e-9);
  check_error("  admissibility", certificate.admissibility_violation, 1e-9);
}

void run()
{
  for (const double strength : {10., 0.3})
  {
    const auto S = tensor(-1.2, 0, 0, -0.8);
    solve(compliant, S, strength, 12);
    solve(hard, S, strength, 30);
    solve(least_energy, S, strength, 3);
    solve(centre, S, strength, 60);
  }
}

const RoomTest test("formulations_large", run);
} // namespace test_formulations_large
