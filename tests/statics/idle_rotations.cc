// SPDX-License-Identifier: LGPL-2.1-or-later

// Bodies that turn, on joints of one contact whose rows no turn moves, have the
// forces of bodies that do not: the rotations are idle, where nothing slides
// and where a part of the joints does.

#include <voussoir/algebra/newton.h>
#include <voussoir/statics/energy/elastic_problem.h>
#include <voussoir/statics/problem/discrete_problem.h>

#include "tests.h"

namespace test_idle_rotations
{
using namespace Voussoir;

/** The structure of the problem, with a third unknown of each body. */
Structure with_idle_rotations(const DiscreteProblem &problem)
{
  Structure::Part part;
  part.kinematics = rotations();
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
  {
    part.centres.push_back(problem.centre(b));
    for (unsigned int i = 0; i < 2; ++i)
      part.loads.push_back(problem.loads()[problem.dof(b, i)]);
    part.loads.push_back(0.);
  }
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    part.joints.add(problem.joints()[e], problem.rows(e), part.kinematics);
  return Structure(ProcessGroup(), std::move(part));
}

std::vector<double> forces(const Structure &structure)
{
  const ElasticJoint law(structure);
  JointSystem system(structure, LinearSolver::direct);
  Newton newton(structure, law, system,
                std::vector<double>(structure.n_dofs(), 0.));
  while (newton.imbalance() > 1e-13 && newton.n_iterations() < 100)
    newton.step(least_shift, newton.u());
  check_error("  imbalance", newton.imbalance(), 1e-12);
  return newton.forces();
}

void run()
{
  for (const double strength : {10., 0.31})
  {
    const DiscreteProblem problem = discretise(scene_under_stress(
        random_packing(100, 1), strength, tensor(-1.3, 0.1, 0.1, -0.7)));
    std::cout << "strength " << strength << std::endl;
    const std::vector<double> expected = forces(problem),
                              found = forces(with_idle_rotations(problem));
    double largest = 0.;
    unsigned int n_sliding = 0;
    for (std::size_t k = 0; k < expected.size(); ++k)
      largest = std::max(largest, std::abs(found[k] - expected[k]));
    for (unsigned int e = 0; e < problem.joints().size(); ++e)
      n_sliding +=
          std::abs(expected[problem.first_row(e) + 1]) >= problem.limit(e);
    check("  some joints slide", (n_sliding > 0) == (strength < 1.));
    check_error("  the forces of translations", largest, 1e-9);
  }
}

const RoomTest test("idle_rotations", run);
} // namespace test_idle_rotations
