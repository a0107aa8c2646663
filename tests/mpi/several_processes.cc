// SPDX-License-Identifier: LGPL-2.1-or-later

// Several processes find what one finds alone: the forces of least energy, by
// either linear solver, the proof of collapse, and the stress in every cell.

#include <voussoir/stress/stress_part.h>

#include "processes.h"
#include "tests.h"

using namespace Voussoir;

/** 3,600 bricks on the ground under their weight. */
Scene heavy_wall(const double strength,
                 const Kinematics &kinematics = translations())
{
  Packing<2> bricks = wall(60, 60);
  std::vector<bool> is_support;
  for (const auto &edge : bricks.boundary_edges())
    is_support.push_back(edge.midpoint()[1] < 1e-9);
  bricks.support(is_support);
  std::vector<double> strengths(bricks.interfaces().size(), strength);
  std::vector<dealii::Tensor<1, 2>> tractions(bricks.boundary_edges().size());
  for (unsigned int b = 0; b < tractions.size(); ++b)
    if (bricks.boundary_edges()[b].normal[1] > 0.5)
      tractions[b] = dealii::Tensor<1, 2>({0.2, -1.});
  BodyForce weight(bricks, [](const auto &, unsigned int) {
    return dealii::Tensor<1, 2>({0., -3.});
  });
  return Scene(std::move(bricks), strengths, {tractions, weight, {}},
               kinematics);
}

/** Two packings that do not touch, of so many random cells each. */
Scene apart(const unsigned int n_left, const unsigned int n_right)
{
  CellLoops cells = voronoi_cells(random_points(n_left, 1, {{0, 0}, {1, 1}}),
                                  Rectangle{{0, 0}, {1, 1}});
  const CellLoops right = voronoi_cells(
      random_points(n_right, 2, {{2, 0}, {3, 1}}), Rectangle{{2, 0}, {3, 1}});
  const unsigned int n_vertices = cells.vertices.size();
  const unsigned int n_loops = cells.loops.size();
  cells.vertices.insert(cells.vertices.end(), right.vertices.begin(),
                        right.vertices.end());
  cells.centres.insert(cells.centres.end(), right.centres.begin(),
                       right.centres.end());
  for (const unsigned int v : right.loops)
    cells.loops.push_back(n_vertices + v);
  for (unsigned int c = 1; c < right.first.size(); ++c)
    cells.first.push_back(n_loops + right.first[c]);
  return scene_under_stress(Packing<2>(cells), 0.3, tensor(-1.45, 0, 0, -0.55));
}

double largest_force(const InterfaceForces &forces)
{
  double largest = 0.;
  for (const auto *component : {&forces.normal, &forces.tangential})
    for (const double f : *component)
      largest = std::max(largest, std::abs(f));
  return largest;
}

void compare_forces(const std::string &name,
                    const Scene &scene,
                    const ProcessGroup &processes,
                    const std::vector<std::string> &methods)
{
  const InterfaceForces alone = Solver(least_energy).forces(scene);
  for (const std::string &method : methods)
  {
    const Method with_method =
        least_energy.with("set Linear solver = " + method);
    const InterfaceForces together =
        Solver(with_method, 1e-10, "", processes).forces(scene);
    check_error(name + ", " + method + ": distance from one process alone",
                distance(alone, together) / largest_force(alone), 1e-10);
    check_error(name + ", " + method + ": equilibrium",
                certify(scene, together).error(), 1e-10);
  }
}

void compare_collapse(const Scene &scene, const ProcessGroup &processes)
{
  const DiscreteProblem problem = discretise(scene);
  const Solution found =
      Solver(least_energy, 1e-10, "", processes).solve(problem);
  check("collapse is found", found.mechanism.has_value());
  if (found.mechanism)
    check("collapse is proven",
          proves_collapse(certify_mechanism(
              scene, dimensional_motion(discretise(scene), *found.mechanism))));
}

/** The sub-cells of the root's own part, which are the first of all. */
void compare_stress(const std::string &name,
                    const Scene &scene,
                    const Reconstruction &how,
                    const ProcessGroup &processes)
{
  Solver solver(least_energy);
  const InterfaceForces forces = solver.forces(scene);
  const Motion u(scene.packing.n_cells(), translations());
  const StressField alone =
      reconstruct_stress(scene, forces, how, solver.quiet);
  const StressPart part =
      reconstruct_on_root(scene, forces, u, how, processes, solver.quiet);
  check(name + ": number of sub-cells",
        part.stress.n_sub_cells == alone.sub_cells.size());
  check(name + ": undetermined cells",
        part.stress.undetermined == alone.undetermined);
  double error = 0.;
  for (unsigned int k = 0; k < part.stress.sub_cells.size(); ++k)
    error = std::max(
        error,
        (part.stress.sub_cells[k].stress - alone.sub_cells[k].stress).norm());
  check_error(name + ": distance from one process alone", error, 1e-12);
}

void run_all(const ProcessGroup &processes)
{
  const auto cells = [](const double d,
                        const Kinematics &kinematics = translations()) {
    return scene_under_stress(random_packing(2400, 1), 0.3,
                              tensor(-1 + d, 0, 0, -1 - d), kinematics);
  };
  // Multigrid talks so much that more processes than cores wait for each other.
  compare_forces("no joint slides", cells(0.2), processes,
                 {"direct", "multigrid"});
  compare_forces("joints slide and open", cells(0.5), processes, {"automatic"});
  compare_forces("on the ground", heavy_wall(0.8), processes, {"automatic"});
  // Cut between the two on two processes, and on three.
  compare_forces("apart", apart(1000, 1000), processes, {"direct"});
  compare_forces("apart, unequal", apart(1500, 3000), processes, {"direct"});
  compare_collapse(cells(0.9), processes);
  compare_forces("blocks turn", cells(0.2, rotations()), processes,
                 {"direct", "multigrid"});
  compare_forces("blocks turn, slide and open", cells(0.4, rotations()),
                 processes, {"automatic"});
  compare_forces("blocks turn, on the ground", heavy_wall(0.8, rotations()),
                 processes, {"automatic"});
  compare_collapse(cells(0.9, rotations()), processes);
  const Scene small =
      scene_under_stress(random_packing(50, 1), 0.5, tensor(-1.1, 0, 0, -0.9));
  compare_stress("standard", small, {false, 0, 0}, processes);
  compare_stress("fine", small, {true, 0, 0}, processes);
  compare_stress("under weight", heavy_wall(0.8), {false, 0, 0}, processes);
}

int main()
{
  run_on_processes(run_all);
}
