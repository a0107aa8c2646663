// SPDX-License-Identifier: LGPL-2.1-or-later

// The reconstruction of whole packings: verification 1 and 2 give sigma = S in
// every sub-cell, homogeneous compression gives -I; the skew part of the mean
// stress is the residual torque; the number of threads changes nothing.

#include <voussoir/stress/cell_means.h>
#include <voussoir/stress/reconstruction.h>

#include <deal.II/base/multithread_info.h>

#include "tests.h"

namespace test_reconstruction_scenes
{
using namespace Voussoir;
using dealii::Tensor;

double error_of_uniform(const Scene &scene,
                        const Tensor<2, 2> &S,
                        const Method &method)
{
  Solver solver(method);
  const InterfaceForces forces = solver.forces(scene);
  double error = 0.;
  for (const auto &sub_cell :
       reconstruct_stress(scene, forces, {}, solver.quiet).sub_cells)
    error = std::max(error, (sub_cell.stress - S).norm());
  for (const auto &mean : cell_mean_stresses(scene, forces))
    error = std::max(error, (mean - S).norm());
  return error;
}

void run()
{
  const auto S = tensor(-1, -1, -1, -1);
  const Rectangle unit = {{0, 0}, {1, 1}};
  PointList<2> squares, triangles;
  squares.points = {{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.25}, {0.75, 0.75}};
  triangles.points = {
      {0.5, 1. / 6}, {0.5, 5. / 6}, {1. / 6, 0.5}, {5. / 6, 0.5}};
  for (const Method &method : all_methods)
    for (const PointList<2> &points : {squares, triangles})
      check_error(
          std::to_string(points.points.size()) + " cells, " + method.name,
          error_of_uniform(scene_under_stress(
                               Packing<2>(voronoi_cells(points, unit)), 10, S),
                           S, method),
          method.name == "linear program" ? 1e-6 : 1e-9);
  check_error("one cell",
              error_of_uniform(scene_under_stress(random_packing(1, 1), 1, S),
                               S, compliant),
              1e-12);
  for (const Method &method : {compliant, least_energy, centre})
    check_error("homogeneous compression, " + method.name,
                error_of_uniform(scene_under_stress(random_packing(60, 4), 10,
                                                    tensor(-1, 0, 0, -1)),
                                 tensor(-1, 0, 0, -1), method),
                1e-9);

  // A state without uniform stress: means, torques, threads.
  const Scene scene =
      scene_under_stress(random_packing(2000, 2), 0.2, tensor(-1.2, 0, 0, -1));
  Solver solver(compliant);
  const InterfaceForces forces = solver.forces(scene);
  const auto field = reconstruct_stress(scene, forces, {}, solver.quiet);
  const auto means = cell_mean_stresses(scene, forces);
  const auto torques = residual_torques(scene, forces);
  check("all cells determined", field.undetermined.empty());

  double skew = 0.;
  for (unsigned int c = 0; c < means.size(); ++c)
    skew = std::max(skew, std::abs(means[c][1][0] - means[c][0][1] -
                                   torques[c] / scene.packing.area(c)));
  check_error("skew part of the means against the torques", skew, 1e-9);

  dealii::MultithreadInfo::set_thread_limit(1);
  const auto single = reconstruct_stress(scene, forces, {}, solver.quiet);
  double difference = 0.;
  for (unsigned int k = 0; k < field.sub_cells.size(); ++k)
    difference = std::max(
        difference,
        (field.sub_cells[k].stress - single.sub_cells[k].stress).norm());
  check_error("one thread or all", difference, 0.);
}

const RoomTest test("reconstruction_scenes", run);
} // namespace test_reconstruction_scenes
