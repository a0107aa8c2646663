// SPDX-License-Identifier: LGPL-2.1-or-later

// Smoothed friction in space: its energy, forces and second derivatives agree
// with each other; extruded scenes have the forces of the plane times the
// thickness; and what collapses is proven to.

#include <voussoir/statics/paper/smoothed_faces.h>
#include <voussoir/statics/paper/smoothed_friction.h>
#include <voussoir/statics/problem/discretise.h>

#include "extruded_scenes.h"
#include <random>

namespace test_space_smoothed
{
using namespace Voussoir;

/** A case of Tresca's friction with a weight and a push. */
struct Pushed
{
  explicit Pushed(const unsigned int k)
      : laws({0.5 + 0.1 * k, 0., 0., k % 2 == 0, {}, {}}),
        packing(on_foot(k % 4 < 2 ? wall(4, 3, 2., 1.)
                                  : random_packing(12 + k, k + 1)))
  {
    laws.dead[0] = 0.05;
    laws.dead[1] = -1.;
  }
  Laws laws;
  Packing<2> packing;
};

void derivatives()
{
  const Pushed scene(2);
  const SpaceCase of = in_space(scene.packing, scene.laws);
  const SpaceScene in_space(of.blocks(),
                            body_force(of.packing, upright(scene.laws.dead)));
  const DiscreteProblem problem = discretise(in_space);
  const SmoothedFace law(problem);
  std::mt19937 generator(1);
  double of_forces = 0., of_second = 0.;
  for (unsigned int e = 0; e < 5; ++e)
  {
    const unsigned int n = problem.n_rows(e);
    std::vector<double> jumps(n), forces(n);
    for (double &jump : jumps)
      jump = generator() / double(std::mt19937::max()) - 0.5;
    law.find_forces(e, jumps.data(), forces.data());
    std::vector<double> second(problem.n_all_coefficients());
    law.find_second_derivatives(e, jumps.data(), second.data());
    constexpr double h = 1e-5;
    for (unsigned int r = 0; r < n; ++r)
    {
      std::vector<double> up = jumps, down = jumps, of_up(n), of_down(n);
      up[r] += h;
      down[r] -= h;
      of_forces = std::max(of_forces, std::abs((law.energy(e, up.data()) -
                                                law.energy(e, down.data())) /
                                                   (2. * h) -
                                               forces[r]));
      law.find_forces(e, up.data(), of_up.data());
      law.find_forces(e, down.data(), of_down.data());
      problem.for_each_set(e, [&](const unsigned int size,
                                  const unsigned int row,
                                  const unsigned int coefficient) {
        for (unsigned int i = 0; i < size && r >= row && r < row + size; ++i)
          of_second =
              std::max(of_second,
                       std::abs((of_up[row + i] - of_down[row + i]) / (2. * h) -
                                second[coefficient + size * i + (r - row)]));
      });
    }
  }
  check_error("forces", of_forces, 1e-8);
  check_error("second derivatives", of_second, 1e-8);
}

void extruded_scenes()
{
  double largest = 0., error = 0.;
  unsigned int n_converged = 0;
  for (unsigned int k = 0; k < 10; ++k)
  {
    const Pushed of_plane(k);
    const Scene plane =
        scene_in_plane(of_plane.packing, of_plane.laws, of_plane.laws.dead);
    const DiscreteProblem in_plane = discretise(plane);
    const InterfaceForces expected = dimensional_forces(
        in_plane, SmoothedFriction().solve(in_plane, {}, Terminal::silent()));
    const SpaceCase of = in_space(of_plane.packing, of_plane.laws);
    const SpaceScene scene(of.blocks(),
                           body_force(of.packing, upright(of_plane.laws.dead)));
    const DiscreteProblem problem = discretise(scene);
    const Solution solution =
        SmoothedFaces().solve(problem, {}, Terminal::silent());
    n_converged += solution.converged() && solution.selection.empty();
    const FaceForces forces = dimensional_forces(problem, scene, solution);
    error = std::max(error, certify(scene, forces).error());
    for (unsigned int e = 0; e < of_plane.packing.interfaces().size(); ++e)
      for (unsigned int f = 0; f < of.packing.interfaces().size(); ++f)
      {
        const auto &i = of_plane.packing.interfaces()[e];
        const auto &face = of.packing.interfaces()[f];
        if (i.cell_minus != face.cell_minus || i.cell_plus != face.cell_plus)
          continue;
        const Vector3 force = forces.resultant(of.packing, f).force;
        const dealii::Tensor<1, 2> wanted = expected.on_cell_minus(i, e);
        largest =
            std::max(largest, (force - thickness * upright(wanted)).norm());
      }
  }
  check("all have converged", n_converged == 10);
  check_error("balance", error, 1e-9);
  check_error("forces of the plane times the thickness", largest, 1e-8);
}

void collapse()
{
  Pushed of_plane(0);
  of_plane.laws.dead[0] = 3.;
  const SpaceCase of = in_space(of_plane.packing, of_plane.laws);
  const SpaceScene scene(of.blocks(),
                         body_force(of.packing, upright(of_plane.laws.dead)));
  const DiscreteProblem problem = discretise(scene);
  const Solution solution =
      SmoothedFaces().solve(problem, {}, Terminal::silent());
  check("a collapse is found", solution.mechanism.has_value());
  if (solution.mechanism)
    check("and proven",
          proves_collapse(certify_mechanism(
              scene,
              dimensional_motion(problem, scene, solution.mechanism->u, 1.))));
}

void run()
{
  derivatives();
  extruded_scenes();
  collapse();
}

const RoomTest test("space_smoothed", run);
} // namespace test_space_smoothed
