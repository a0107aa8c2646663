// SPDX-License-Identifier: LGPL-2.1-or-later

// What the analytic centre selects: the state f in which the derivative of
// sum_e w_e (log p + log(b - q) + log(b + q)) vanishes towards every other
// balanced state g. It depends neither on the start nor on the tolerance, and
// with edge-area weights returns homogeneous compression.

#include <voussoir/statics/energy/barrier_joint.h>
#include <voussoir/statics/energy/minimise.h>

#include "tests.h"

namespace test_analytic_centre_selection
{
using namespace Voussoir;

/** That derivative along g - f, over the sum of its terms' sizes. */
double derivative(const Scene &scene,
                  const bool equal_weights,
                  const InterfaceForces &f,
                  const InterfaceForces &g)
{
  double sum = 0., size = 0.;
  for (unsigned int e = 0; e < f.normal.size(); ++e)
  {
    const auto &i = scene.packing.interfaces()[e];
    const double d = (scene.packing.centre(i.cell_plus) -
                      scene.packing.centre(i.cell_minus)) *
                     i.normal;
    const double w = equal_weights ? 1. : i.length * d;
    const double b = scene.strength[e] * i.length, q = f.tangential[e];
    const double normal = w * (g.normal[e] - f.normal[e]) / f.normal[e];
    const double tangential =
        -w * (g.tangential[e] - q) * 2. * q / ((b - q) * (b + q));
    sum += normal + tangential;
    size += std::abs(normal) + std::abs(tangential);
  }
  return std::abs(sum) / size;
}

/** The forces from Newton's method begun at u_c = A x_c + a. */
InterfaceForces from_start(const Scene &scene,
                           const BarrierWeights weights,
                           const dealii::Tensor<2, 2> &A)
{
  const DiscreteProblem problem = discretise(scene);
  const BarrierJoint law(problem, weights);
  JointSystem system(problem, LinearSolver::direct);
  std::vector<double> u;
  for (unsigned int b = 0; b < problem.n_bodies(); ++b)
    for (unsigned int i = 0; i < 2; ++i)
      u.push_back(A[i][0] * problem.centre(b)[0] +
                  A[i][1] * problem.centre(b)[1] + 3.);
  Newton newton(problem, law, system, u);
  std::ostringstream nowhere;
  Terminal &quiet = Terminal::silent();
  return dimensional_forces(problem, minimise(
                                         SharedProblem(problem), newton,
                                         {1e-10, 200, 1e-7},
                                         [&]() -> std::optional<Mechanism> {
                                           newton.step(least_shift, newton.u());
                                           return {};
                                         },
                                         quiet));
}

void run()
{
  const Scene scene = scene_under_stress(random_packing(150, 3), 0.5,
                                         tensor(-1.2, 0.1, 0.1, -0.8));
  for (const Method &method : {centre, centre_equal})
  {
    const bool equal = method.name != centre.name;
    const InterfaceForces f = Solver(method).forces(scene);
    std::cout << method.name << std::endl;
    for (const Method &other : all_methods)
      if (other.name != method.name)
        check_error("  derivative towards " + other.name,
                    derivative(scene, equal, f, Solver(other).forces(scene)),
                    1e-9);
    for (const double tolerance : {1e-8, 1e-9, 1e-12})
      check_error("  another tolerance",
                  distance(f, Solver(method, tolerance).forces(scene)), 1e-8);
    // Displacements that open every joint, since A is positive definite and
    // the line between two centres normal to their joint.
    for (const auto &A : {tensor(1e-4, 0, 0, 1e-4), tensor(1e4, 0, 0, 1e4),
                          tensor(1, 0.9, 0.9, 1), tensor(0.01, 5, -5, 10)})
      check_error("  another start",
                  distance(f, from_start(scene,
                                         equal ? BarrierWeights::equal
                                               : BarrierWeights::edge_area,
                                         A)),
                  1e-8);
  }

  const auto pressure = tensor(-1, 0, 0, -1);
  // The directions of the shortest interfaces of many cells are known to 1e-10
  // only.
  for (const auto &[n, tolerance] : {std::make_pair(60u, 1e-9), {1000u, 1e-8}})
  {
    const Scene compressed =
        scene_under_stress(random_packing(n, 4), 10, pressure);
    check_error("homogeneous compression",
                distance_from_uniform(
                    compressed, Solver(centre).forces(compressed), pressure),
                tolerance);
  }
}

const RoomTest test("analytic_centre_selection", run);
} // namespace test_analytic_centre_selection
