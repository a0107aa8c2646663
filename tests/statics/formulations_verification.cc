// SPDX-License-Identifier: LGPL-2.1-or-later

// Verification 1 and 2 (Marazzato and Venkataramani): four squares and four
// triangles that meet in a point, under the uniform stress S = -[[1,1],[1,1]].
// The forces are those of S, f_e = |e| S n_e, under every formulation. The four
// triangles have no strictly admissible state: two joints carry no force.

#include "tests.h"

namespace test_formulations_verification
{
using namespace Voussoir;

void verify(const std::string &name,
            const std::vector<dealii::Point<2>> &points,
            const Method &method)
{
  const auto S = tensor(-1, -1, -1, -1);
  PointList<2> list;
  list.points = points;
  const Scene scene = scene_under_stress(
      Packing<2>(voronoi_cells(list, {{0, 0}, {1, 1}})), 10, S);
  const DiscreteProblem problem = discretise(scene);
  const Solution solution = Solver(method).solve(problem);
  const InterfaceForces forces = dimensional_forces(problem, solution);

  std::cout << name << ", " << method.name << ": " << forces.normal.size()
            << " interfaces" << std::endl;
  check_error("  error of the tractions",
              distance_from_uniform(scene, forces, S),
              method.name == "linear program" ? 1e-6 : 1e-9);
  check_error("  equilibrium", certify(scene, forces).equilibrium_residual,
              1e-9);
  check_error("  admissibility", certify(scene, forces).admissibility_violation,
              1e-9);
  if (!solution.never_pressed.empty())
    std::cout << "  never pressed: "
              << std::count(solution.never_pressed.begin(),
                            solution.never_pressed.end(), true)
              << ", always sliding: "
              << std::count(solution.always_sliding.begin(),
                            solution.always_sliding.end(), true)
              << std::endl;
}

void run()
{
  for (const Method &method : all_methods)
  {
    verify("verification 1",
           {{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.25}, {0.75, 0.75}}, method);
    verify("verification 2",
           {{0.5, 1. / 6}, {0.5, 5. / 6}, {1. / 6, 0.5}, {5. / 6, 0.5}},
           method);
  }
}

const RoomTest test("formulations_verification", run);
} // namespace test_formulations_verification
