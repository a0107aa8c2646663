// SPDX-License-Identifier: LGPL-2.1-or-later

// Several processes find what one finds alone of blocks in space: the forces of
// least energy, by either linear solver, and the stress in every tetrahedron.

#include <voussoir/stress/linear_stress.h>
#include <voussoir/stress/shared_tetrahedra.h>

#include "../statics/space_scenes.h"
#include "processes.h"

using namespace Voussoir;
using dealii::Point;

FaceForces forces_by(const SpaceScene &scene,
                     const LinearSolver linear_solver,
                     const ProcessGroup &processes)
{
  const DiscreteProblem problem = discretise(scene);
  SolverControls controls;
  controls.processes = processes;
  return dimensional_forces(
      problem, scene,
      find_space_state(problem, controls, linear_solver, Terminal::silent()));
}

/** The largest difference of a force, over the largest. */
double difference(const FaceForces &a, const FaceForces &b)
{
  double largest = 0., error = 0.;
  for (std::size_t k = 0; k < a.list.size(); ++k)
  {
    largest = std::max(largest, a.list[k].force.norm());
    error = std::max(error, (a.list[k].force - b.list[k].force).norm());
  }
  return error / largest;
}

void compare(const std::string &name,
             const SpaceCase &of,
             const SpaceLoads &loads,
             const std::vector<LinearSolver> &linear_solvers,
             const ProcessGroup &processes)
{
  const SpaceScene scene(of.blocks(), loads);
  const FaceForces alone =
      forces_by(scene, LinearSolver::automatic, ProcessGroup());
  for (const LinearSolver linear_solver : linear_solvers)
  {
    const FaceForces together = forces_by(scene, linear_solver, processes);
    check_error(name + ": distance from one process alone",
                difference(alone, together), 1e-9);
    check_error("  equilibrium", certify(scene, together).error(), 1e-10);
  }
  const auto means = cell_mean_stresses(scene, alone);
  const TetrahedralStress stress = tetrahedral_stress(scene, alone, means),
                          shared = tetrahedral_stress(scene, alone, means,
                                                      processes);
  check("  as many tetrahedra", stress.first == shared.first &&
                                    stress.list.size() == shared.list.size() &&
                                    stress.undetermined == shared.undetermined);
  double error = 0.;
  for (std::size_t t = 0; t < stress.list.size(); ++t)
    error =
        std::max(error, (stress.list[t].stress - shared.list[t].stress).norm());
  check("  with the same stress", error == 0.);
}

/** Random cells under a stress and their weight, between five walls. */
void random_cells(const std::string &name,
                  const double strength,
                  const double mu,
                  const bool turns,
                  const std::vector<LinearSolver> &linear_solvers,
                  const ProcessGroup &processes)
{
  SpaceCase of{cells_in_box(1000, {1., 1., 1.}, 4)};
  of.support([](const auto &face) { return face.normal[2] < 0.5; });
  of.strength = strength;
  of.mu = mu;
  of.turns = turns;
  dealii::Tensor<2, 3> S;
  S[2][2] = -1.;
  S[0][2] = S[2][0] = 0.2;
  compare(name, of,
          together(tractions(of.packing, S), 1.,
                   body_force(of.packing, vector(0., 0., -1.))),
          linear_solvers, processes);
}

void run_all(const ProcessGroup &processes)
{
  const std::vector<LinearSolver> both = {LinearSolver::direct,
                                          LinearSolver::multigrid},
                                  automatic = {LinearSolver::automatic};
  random_cells("No joint slides", 10., 0., false, both, processes);
  random_cells("Joints slide", 0.1, 0., false, automatic, processes);
  random_cells("With Coulomb's friction", 0., 0.4, false, automatic, processes);
  random_cells("Blocks turn", 10., 0., true, automatic, processes);
  random_cells("Blocks turn and slide", 0.1, 0.3, true, automatic, processes);
  SpaceCase wall{Packing<3>(brick_wall(40, 1, 25))};
  wall.mu = 0.6;
  wall.tension = 0.05;
  compare("A wall", wall, body_force(wall.packing, vector(0.1, 0.01, -1.)),
          automatic, processes);
}

int main()
{
  run_on_processes(run_all);
}
