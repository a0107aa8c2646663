// SPDX-License-Identifier: LGPL-2.1-or-later

// Bodies that turn, on joints of one contact whose rows no turn moves, have the
// forces and the verdict of bodies that do not: the rotations are idle, in all
// formulations, where the load is carried and where it is not.

#include <voussoir/statics/problem/discrete_problem.h>

#include "tests.h"

namespace test_idle_rotations
{
using namespace Voussoir;

/** The problem with a third unknown of each body. */
DiscreteProblem with_idle_rotations(const DiscreteProblem &problem)
{
  DiscreteProblem::Data data;
  data.part.kinematics = rotations();
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
  {
    data.part.centres.push_back(problem.centre(b));
    for (unsigned int i = 0; i < 2; ++i)
      data.part.loads.push_back(problem.loads()[problem.dof(b, i)]);
    data.part.loads.push_back(0.);
  }
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
    data.part.joints.add(problem.joints()[e], problem.rows(e),
                         data.part.kinematics);
  data.n_cells = problem.n_cells();
  data.is_loaded = problem.is_loaded();
  data.length_unit = problem.length_scale();
  data.stress_unit = problem.stress_scale();
  data.coordinate_rounding = problem.rounding_of_coordinates();
  return DiscreteProblem(std::move(data));
}

void compare(const std::string &name,
             const Method &method,
             const DiscreteProblem &problem)
{
  const Solution expected = Solver(method).solve(problem);
  const Solution found = Solver(method).solve(with_idle_rotations(problem));
  check(name + ", " + method.name + ": the same verdict",
        found.mechanism.has_value() == expected.mechanism.has_value() &&
            found.converged() == expected.converged());
  if (expected.mechanism || method.name == linear_program.name)
    return; // whose forces are any
  double largest = 0.;
  for (std::size_t k = 0; k < expected.forces.size(); ++k)
    largest = std::max(largest, std::abs(found.forces[k] - expected.forces[k]));
  check_error("  the same forces", largest, 1e-8);
}

void run()
{
  for (const double strength : {0.35, 0.1})
    for (const Method &method : all_methods)
      compare(strength > 0.2 ? "carried" : "not carried", method,
              discretise(scene_under_stress(random_packing(100, 1), strength,
                                            tensor(-1.3, 0.1, 0.1, -0.7))));
}

const RoomTest test("idle_rotations", run);
} // namespace test_idle_rotations
