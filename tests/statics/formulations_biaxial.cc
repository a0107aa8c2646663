// SPDX-License-Identifier: LGPL-2.1-or-later

// The load S = diag(-1 + d, -1 - d) with s_T = 0.3. In square blocks turned by
// 45 degrees straight joints lie in the planes of largest shear, and the limit
// is d = s_T: any smaller d is carried by the uniform state, any larger one
// slides along such a plane. In 1,000 random Voronoi cells blocks that slide
// have to climb, and the limit is higher, between the proofs below.

#include "tests.h"

namespace test_formulations_biaxial
{
using namespace Voussoir;

void try_load(const Method &method, const Packing<2> &packing, const double d)
{
  const Scene scene =
      scene_under_stress(packing, 0.3, tensor(-1 + d, 0, 0, -1 - d));
  const DiscreteProblem problem = discretise(scene);
  const Solution solution = Solver(method).solve(problem);
  std::cout << "  " << method.name << ", d = " << d << ": ";
  if (solution.mechanism)
  {
    const auto proof = certify_mechanism(
        scene, dimensional_motion(discretise(scene), *solution.mechanism));
    std::cout << "collapse "
              << (proof.closing_violation <= 1e-12 &&
                          proof.work_over_dissipation > 1.
                      ? "proven"
                      : "FAILED")
              << std::endl;
    return;
  }
  const Certificate certificate =
      certify(scene, dimensional_forces(problem, solution));
  std::cout << "carried "
            << (certificate.equilibrium_residual <= 1e-8 &&
                        certificate.admissibility_violation <= 1e-8
                    ? "with certificate"
                    : "FAILED")
            << std::endl;
}

void run()
{
  const Packing<2> squares = turned_squares(46);
  std::cout << squares.n_cells() << " turned squares" << std::endl;
  for (const Method &method : all_methods)
    for (const double d : {0.2999, 0.31, 2.})
      try_load(method, squares, d);

  std::cout << "1000 random cells" << std::endl;
  const Packing<2> random = random_packing(1000, 1);
  for (const Method &method : all_methods)
    for (const double d : {0.2999, 0.31, 0.65, 0.651, 0.9})
      try_load(method, random, d);
}

const RoomTest test("formulations_biaxial", run);
} // namespace test_formulations_biaxial
